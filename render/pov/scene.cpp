#include "render/pov/scene.h"
#include "field/error.h"
namespace cydonia::render {
std::string pov_scene(const Shot&, const Heights16&, double) {
    throw failure("not built yet");
}
void write_pov_assets(const std::filesystem::path&, const Terrain&, const Options&) {
    throw failure("not built yet");
}
void write_pov_scene(const std::filesystem::path&, const Shot&, const Terrain&) {
    throw failure("not built yet");
}
}  // namespace cydonia::render
