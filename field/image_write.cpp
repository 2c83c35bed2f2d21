#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <vector>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"

namespace cydonia {
namespace {

// The x and y of red, green, blue and white in the ACES document S-2014-004.
constexpr float kAcesCgChromaticities[8] = {0.713f, 0.293f, 0.165f,   0.830f,
                                            0.128f, 0.044f, 0.32168f, 0.33767f};

// Encodes an image in memory, so that only write_text() writes to the disk: OpenImageIO
// does not notice every write that fails.
std::string encoded(const std::string& name, const char* format,
                    const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                    const void* values) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) throw failure("cannot write {}: {}", name, OIIO::geterror());
    output->set_ioproxy(&memory);
    if (!output->open(name, spec) || !output->write_image(type, values) ||
        !output->close())
        throw failure("cannot write {}: {}", name, output->geterror());
    return {bytes.begin(), bytes.end()};
}

void write_image(const std::filesystem::path& path, const char* format,
                 const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* values) {
    write_text(path, encoded(path.string(), format, spec, type, values));
}

template <class T>
void write_png_of(const std::filesystem::path& path, const Field<T>& image, int channels,
                  OIIO::TypeDesc type, const char* colour_space, int level) {
    OIIO::ImageSpec spec(image.width(), image.height(), channels, type);
    spec["png:compressionLevel"] = level;
    spec["oiio:ColorSpace"] = colour_space;
    write_image(path, "png", spec, type, image.data());
}

template <class T>
void write_exr_of(const std::filesystem::path& path, const Field<T>& image,
                  OIIO::ImageSpec spec, const Metadata& metadata) {
    spec["compression"] = "zip";
    spec["DateTime"] = "";  // the same values give the same bytes on any day
    for (const auto& [name, value] : metadata) spec[name] = value;
    write_image(path, "openexr", spec, OIIO::TypeFloat, image.data());
}

}  // namespace

void write_png(const std::filesystem::path& path, const Field<std::uint8_t>& grey,
               int level) {
    write_png_of(path, grey, 1, OIIO::TypeUInt8, "sRGB", level);
}

// The values are mostly heights: they are labelled linear and left unchanged.
void write_png(const std::filesystem::path& path, const Field<std::uint16_t>& grey,
               int level) {
    write_png_of(path, grey, 1, OIIO::TypeUInt16, "Linear", level);
}

void write_png(const std::filesystem::path& path, const Field<Rgb8>& rgb, int level) {
    write_png_of(path, rgb, 3, OIIO::TypeUInt8, "sRGB", level);
}

std::string png_of(const Field<Rgb8>& rgb) {
    OIIO::ImageSpec spec(rgb.width(), rgb.height(), 3, OIIO::TypeUInt8);
    return encoded("picture.png", "png", spec, OIIO::TypeUInt8, rgb.data());
}

std::string jpeg_of(const Field<Rgb8>& rgb, int quality) {
    OIIO::ImageSpec spec(rgb.width(), rgb.height(), 3, OIIO::TypeUInt8);
    spec["oiio:ColorSpace"] = "sRGB";
    spec["Compression"] = fmt::format("jpeg:{}", quality);
    return encoded("picture.jpg", "jpeg", spec, OIIO::TypeUInt8, rgb.data());
}

void write_exr(const std::filesystem::path& path, const Field<float>& values,
               const std::string& channel, const Metadata& metadata) {
    OIIO::ImageSpec spec(values.width(), values.height(), 1, OIIO::TypeFloat);
    spec.channelnames = {channel};
    write_exr_of(path, values, spec, metadata);
}

void write_exr(const std::filesystem::path& path, const Field<Rgb>& rgb,
               const Metadata& metadata, Primaries primaries) {
    OIIO::ImageSpec spec(rgb.width(), rgb.height(), 3, OIIO::TypeHalf);
    if (primaries == Primaries::kAcesCg)
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                       kAcesCgChromaticities);
    write_exr_of(path, rgb, spec, metadata);
}

}  // namespace cydonia
