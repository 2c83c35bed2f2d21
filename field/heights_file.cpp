#include "field/heights_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>

#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/geotiff.h"
#include "field/quantise.h"

namespace cydonia {
namespace {

StoredHeights stored(std::string_view type, const auto& values) {
    const auto [low, high] = std::ranges::minmax(values);
    return {type, 0.0, 1.0, static_cast<double>(low), static_cast<double>(high)};
}

StoredHeights in_metres(const Terrain& terrain) {
    return stored("float32", terrain.heights);
}

StoredHeights in_levels(const Heights16& heights) {
    StoredHeights result = stored("uint16", heights.levels);
    result.offset = heights.base;
    result.scale = heights.range / 65535.0;
    return result;
}

// The bytes as they lie in memory, since every processor that we build for is
// little-endian.
template <class T>
std::string bytes_of(const Field<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

// Rows run from north to south and columns from west to east, at the cells' centres.
std::string xyz_of(const Terrain& terrain) {
    const Field<float>& heights = terrain.heights;
    if (std::max(heights.width(), heights.height()) > kMostXyzSamples)
        throw bad_request("xyz: text of more than {0} x {0} samples; add --samples {0}",
                          kMostXyzSamples);
    std::string text;
    text.reserve(28 * heights.size());
    for (int y = 0; y < heights.height(); ++y) {
        const double north = terrain.spacing * (heights.height() - y - 0.5);
        for (int x = 0; x < heights.width(); ++x)
            fmt::format_to(std::back_inserter(text), "{} {} {}\n",
                           terrain.spacing * (x + 0.5), north, heights(x, y));
    }
    return text;
}

// GDAL writes a Terragen file only from a grid in metres.
Dataset new_ter(const char* name, const Terrain& terrain) {
    const auto [low, high] = std::ranges::minmax(terrain.heights);
    // GDAL's rounding may slightly exceed the range that it is given.
    const double margin = 0.001 * std::max(1.0, static_cast<double>(high) - low);
    const std::string least = fmt::format("MINUSERPIXELVALUE={}", low - margin);
    const std::string most = fmt::format("MAXUSERPIXELVALUE={}", high + margin);
    const std::array<const char*, 3> options{least.c_str(), most.c_str(), nullptr};
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("Terragen");
    Dataset file(driver ? driver->Create(name, terrain.heights.width(),
                                         terrain.heights.height(), 1, GDT_Float32,
                                         const_cast<char**>(options.data()))
                        : nullptr);
    if (!file) return file;
    double north_west[6] = {0.0, terrain.spacing, 0.0, terrain.depth(),
                            0.0, -terrain.spacing};
    const OGRSpatialReference plane = local_metres();
    file->SetGeoTransform(north_west);
    file->SetSpatialRef(&plane);
    return file;
}

// The scale and offset that another reader gets from the file.
StoredHeights read_back(const char* name) {
    const Dataset file(GDALDataset::Open(name));
    if (!file) throw failure("GDAL: {}", QuietGdal::message());
    Field<float> values(file->GetRasterXSize(), file->GetRasterYSize());
    load(*file, values);
    StoredHeights result = stored("int16", values);
    GDALRasterBand& band = *file->GetRasterBand(1);
    result.offset = band.GetOffset();
    result.scale = band.GetScale();
    result.from_south = true;
    return result;
}

StoredHeights write_ter(const std::filesystem::path& path, const Terrain& terrain) {
    const QuietGdal quiet;
    const MemoryFile memory;
    if (const Dataset file = new_ter(memory.name(), terrain)) {
        store(terrain.heights, *file);
        file->FlushCache(true);
    }
    if (CPLGetLastErrorType() >= CE_Failure || memory.bytes().empty())
        throw failure("cannot write {}: {}", path.string(), QuietGdal::message());
    write_text(path, memory.bytes());
    return read_back(memory.name());
}

struct Named {
    std::string_view name, extension;
};
constexpr std::array<Named, 7> kNames{{{"ter", "ter"},
                                       {"tif", "tif"},
                                       {"png16", "png"},
                                       {"raw16", "r16"},
                                       {"raw32", "r32"},
                                       {"exr", "exr"},
                                       {"xyz", "xyz"}}};

}  // namespace

std::string_view name_of(HeightFormat format) {
    return kNames[static_cast<std::size_t>(format)].name;
}

std::string_view extension_of(HeightFormat format) {
    return kNames[static_cast<std::size_t>(format)].extension;
}

StoredHeights write_heights(const std::filesystem::path& path, const Terrain& terrain,
                            HeightFormat format, const Metadata& metadata) {
    switch (format) {
        case HeightFormat::kTer:
            return write_ter(path, terrain);
        case HeightFormat::kTif:
            write_geotiff(path, terrain);
            return in_metres(terrain);
        case HeightFormat::kPng16: {
            const Heights16 heights = quantised(terrain.heights);
            write_png(path, heights.levels);
            return in_levels(heights);
        }
        case HeightFormat::kRaw16: {
            const Heights16 heights = quantised(terrain.heights);
            write_text(path, bytes_of(heights.levels));
            return in_levels(heights);
        }
        case HeightFormat::kRaw32:
            write_text(path, bytes_of(terrain.heights));
            return in_metres(terrain);
        case HeightFormat::kExr:
            write_exr(path, terrain.heights, "Y", metadata);
            return in_metres(terrain);
        case HeightFormat::kXyz:
            break;
    }
    write_text(path, xyz_of(terrain));
    return stored("decimal", terrain.heights);
}

}  // namespace cydonia
