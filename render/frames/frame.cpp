#include "render/frames/frame.h"
#include "field/error.h"
namespace cydonia::render {
void deliver_frame(const std::filesystem::path&, const std::filesystem::path&,
                   const std::string&, const ColourOptions&, const Metadata&) {
    throw failure("not built yet");
}
}  // namespace cydonia::render
