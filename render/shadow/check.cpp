#include "render/shadow/check.h"
#include "field/error.h"
namespace cydonia::render {
ShadowScore score(const Field<std::uint8_t>&, const Field<std::uint8_t>&) {
    throw failure("not built yet");
}
std::vector<ShadowReport> check(const Terrain&, const std::filesystem::path&, Progress&) {
    throw failure("not built yet");
}
std::string advice(const ShadowReport&) { throw failure("not built yet"); }
}  // namespace cydonia::render
