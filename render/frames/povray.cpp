#include "render/frames/povray.h"
#include "field/error.h"
namespace cydonia::render {
std::filesystem::path povray_program() { throw failure("not built yet"); }
void run_povray(const std::filesystem::path&, const std::string&, int,
                std::chrono::seconds, Progress&) {
    throw failure("not built yet");
}
}  // namespace cydonia::render
