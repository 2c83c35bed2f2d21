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

// Luma of stored values, 0 to 1, over white.
inline float grey_over_white(Rgba8 pixel) {
    const float luma =
        0.2126f * float(pixel[0]) + 0.7152f * float(pixel[1]) + 0.0722f * float(pixel[2]);
    return 1.0f - float(pixel[3]) / 255.0f * (1.0f - luma / 255.0f);
}

// Names and values for a file's header: {"cydonia:seed", "7"}.
using Metadata = std::map<std::string, std::string>;

// How many pixels its header promises; 0 where it cannot be read.
std::uint64_t pixels_of(const Source& source);

// Images come from strangers: at most 16384 x 16384 pixels, refused before anything is
// allocated. Every reader throws bad_request, naming the file and what is wrong with it.
Field<Rgba8> read_rgba(const Source& source);
// Luma of the stored values, 0 to 1, over white where the image is transparent.
Field<float> read_grey(const Source& source);
// A linear RGB EXR, as POV-Ray writes it.
Field<Rgb> read_exr_rgb(const std::filesystem::path& path);
// A single-channel 32-bit EXR; `metadata` takes its string attributes when given.
Field<float> read_exr(const std::filesystem::path& path, Metadata* metadata = nullptr);

// Written to a temporary name and renamed (field/files.h).
// `level` of compression: 6 for what is kept and sent, 1 for what a program reads once
// and soon, in a quarter of the time.
void write_png(const std::filesystem::path& path, const Field<std::uint8_t>& grey,
               int level = 6);
void write_png(const std::filesystem::path& path, const Field<std::uint16_t>& grey,
               int level = 6);
void write_png(const std::filesystem::path& path, const Field<Rgb8>& rgb, int level = 6);
// A PNG's bytes.
std::string png_of(const Field<Rgb8>& rgb);
// A JPEG's bytes, for pages to look at; quality 1 to 100.
std::string jpeg_of(const Field<Rgb8>& rgb, int quality);
void write_exr(const std::filesystem::path& path, const Field<float>& values,
               const std::string& channel, const Metadata& metadata = {});
// Which light the red, green and blue of an EXR stand for. Rec.709 is what an unlabelled
// file means; ACEScg is written as the standard `chromaticities` attribute.
enum class Primaries { kRec709, kAcesCg };
// Half float, zip.
void write_exr(const std::filesystem::path& path, const Field<Rgb>& rgb,
               const Metadata& metadata = {}, Primaries primaries = Primaries::kRec709);

// Stretched to width x height, each axis by itself: area average where it shrinks,
// bilinear where it grows. For masks and targets.
Field<float> resized(const Field<float>& image, int width, int height);
// Averaged to at most `samples`, 2 or more, along the longer side, the other in
// proportion.
Field<float> at_most(const Field<float>& image, int samples);

}  // namespace cydonia
