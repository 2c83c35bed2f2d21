#include "field/image.h"
#include "field/error.h"
namespace cydonia {
Field<Rgba8> read_rgba(const Source&) { throw failure("not built yet"); }
Field<float> read_grey(const Source&) { throw failure("not built yet"); }
Field<Rgb> read_exr_rgb(const std::filesystem::path&) { throw failure("not built yet"); }
Field<float> read_exr(const std::filesystem::path&, Metadata*) {
    throw failure("not built yet");
}
void write_png(const std::filesystem::path&, const Field<std::uint8_t>&) {
    throw failure("not built yet");
}
void write_png(const std::filesystem::path&, const Field<std::uint16_t>&) {
    throw failure("not built yet");
}
void write_png(const std::filesystem::path&, const Field<Rgb8>&) {
    throw failure("not built yet");
}
void write_exr(const std::filesystem::path&, const Field<float>&, const std::string&,
               const Metadata&) {
    throw failure("not built yet");
}
void write_exr(const std::filesystem::path&, const Field<Rgb>&, const Metadata&) {
    throw failure("not built yet");
}
Field<float> resized(const Field<float>&, int, int) { throw failure("not built yet"); }
}  // namespace cydonia
