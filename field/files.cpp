#include "field/files.h"
#include "field/error.h"
namespace cydonia {
void write_atomically(const std::filesystem::path&,
                      const std::function<void(const std::filesystem::path&)>&) {
    throw failure("not built yet");
}
void write_text(const std::filesystem::path&, std::string_view) {
    throw failure("not built yet");
}
std::string read_text(const std::filesystem::path&, std::size_t) {
    throw failure("not built yet");
}
void make_folder(const std::filesystem::path&) { throw failure("not built yet"); }
}  // namespace cydonia
