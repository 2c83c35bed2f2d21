#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "field/field.h"
#include "field/source.h"

namespace cydonia {

using Rgba8 = std::array<std::uint8_t, 4>;
using Rgb8 = std::array<std::uint8_t, 3>;
using Rgb = std::array<float, 3>;  // linear

// The luma of a pixel's stored values over white, 0 to 1.
inline float grey_over_white(Rgba8 pixel) {
    const float luma =
        0.2126f * float(pixel[0]) + 0.7152f * float(pixel[1]) + 0.0722f * float(pixel[2]);
    return 1.0f - float(pixel[3]) / 255.0f * (1.0f - luma / 255.0f);
}

// Names and values for a file's header: {"cydonia:seed", "7"}.
using Metadata = std::map<std::string, std::string>;

// The number of pixels that the header of an image promises; 0 when it cannot be read.
std::uint64_t pixels_of(const Source& source);

// The files are not to be trusted: more than 16384 x 16384 pixels are refused before
// anything is allocated. Every reader throws bad_request, naming the file and what is
// wrong with it.
Field<Rgba8> read_rgba(const Source& source);
// Luma of the stored values, 0 to 1, over white where the image is transparent.
Field<float> read_grey(const Source& source);
// A linear RGB EXR, as POV-Ray writes it.
Field<Rgb> read_exr_rgb(const std::filesystem::path& path);
// A single-channel 32-bit EXR; `metadata` takes its string attributes when given.
Field<float> read_exr(const std::filesystem::path& path, Metadata* metadata = nullptr);

// The writers write to a temporary name and rename it (field/files.h). `level` is the
// compression: 6 for files that are kept or sent; 1, in a quarter of the time, for files
// that a program reads once and soon.
void write_png(const std::filesystem::path& path, const Field<std::uint8_t>& grey,
               int level = 6);
void write_png(const std::filesystem::path& path, const Field<std::uint16_t>& grey,
               int level = 6);
void write_png(const std::filesystem::path& path, const Field<Rgb8>& rgb, int level = 6);
// The bytes of a PNG.
std::string png_of(const Field<Rgb8>& rgb);
// The bytes of a JPEG, for pages to look at. `quality` goes from 1 to 100.
std::string jpeg_of(const Field<Rgb8>& rgb, int quality);
void write_exr(const std::filesystem::path& path, const Field<float>& values,
               const std::string& channel, const Metadata& metadata = {});
// The primaries of the colours in an EXR. A file without a label means Rec.709; ACEScg is
// written as the standard `chromaticities` attribute.
enum class Primaries { kRec709, kAcesCg };
// Writes half floats with zip compression.
void write_exr(const std::filesystem::path& path, const Field<Rgb>& rgb,
               const Metadata& metadata = {}, Primaries primaries = Primaries::kRec709);

// Stretches an image to width x height, each axis by itself: by area average where it
// shrinks, bilinearly where it grows. For masks and targets.
Field<float> resized(const Field<float>& image, int width, int height);
// Averages an image down to at most `samples` (2 or more) along its longer side, the
// other in proportion.
Field<float> at_most(const Field<float>& image, int samples);

}  // namespace cydonia
