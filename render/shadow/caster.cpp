#include "render/shadow/caster.h"
#include "field/error.h"
namespace cydonia::render {
struct Caster::Scene {};
Caster::Caster(const Field<float>&, double) { throw failure("not built yet"); }
Caster::~Caster() = default;
Caster::Caster(Caster&&) noexcept = default;
Caster& Caster::operator=(Caster&&) noexcept = default;
Field<std::uint8_t> Caster::shadow(const Sun&, int) const {
    throw failure("not built yet");
}
}  // namespace cydonia::render
