#pragma once

#include <filesystem>
#include <string_view>

#include "field/image.h"
#include "field/terrain.h"

namespace cydonia {

// Formats of heights for other programs. Rows run from north to south and columns from
// west to east, except in Terragen files, whose rows run from south to north.
enum class HeightFormat {
    kTer,    // Terragen: 16 bits
    kTif,    // GeoTIFF: 32-bit float metres
    kPng16,  // grey, 16 bits from the lowest height to the highest
    kRaw16,  // the same 16 bits without a header, little-endian
    kRaw32,  // 32-bit float metres without a header, little-endian
    kExr,    // OpenEXR: 32-bit float metres
    kXyz,    // text: east, north and height in metres, a line a sample
};

// The format's name on the command line, such as "png16", and the extension of its files,
// such as "png".
std::string_view name_of(HeightFormat format);
std::string_view extension_of(HeightFormat format);

// What the stored values of a file stand for: metres = offset + scale * value.
struct StoredHeights {
    std::string_view type;  // "uint16", "int16", "float32" or "decimal"
    double offset = 0.0, scale = 1.0;
    double lowest = 0.0, highest = 0.0;  // stored values
    bool from_south = false;             // the first row in the file is the southernmost
};

inline constexpr int kMostXyzSamples = 4096;  // a side: half a gigabyte of text

// Writes the land's heights, metres. Throws failure(), and bad_request for a text of more
// than kMostXyzSamples a side and for land that Terragen's format cannot hold.
StoredHeights write_heights(const std::filesystem::path& path, const Terrain& terrain,
                            HeightFormat format, const Metadata& metadata = {});

}  // namespace cydonia
