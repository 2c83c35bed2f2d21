#include "field/dem.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "field/dem_grid.h"
#include "field/error.h"
#include "field/gdal.h"
#include "field/image.h"

namespace cydonia {
namespace {

bool is_exr(const Source& source) {
    char bytes[4] = {};
    std::ifstream(source.path, std::ios::binary).read(bytes, sizeof bytes);
    return std::string_view(bytes, 4) == "\x76\x2f\x31\x01";
}

// Whoever asks for the mask of voids accepts any number of them.
double most_voids(const Field<std::uint8_t>* asked) { return asked ? 1.0 : kMostVoids; }

// Reads a terrain.exr of this program.
Terrain terrain_of_exr(Field<float> heights, const Metadata& metadata, Notes& notes,
                       Field<std::uint8_t>* voids) {
    const auto known = metadata.find("cydonia:spacing");
    Terrain terrain;
    terrain.spacing =
        known == metadata.end() ? 0.0 : std::strtod(known->second.c_str(), nullptr);
    if (!(terrain.spacing > 0.0 && std::isfinite(terrain.spacing)))
        throw bad_request(
            "it has no attribute cydonia:spacing, so the size of its cells is unknown; "
            "give a GeoTIFF");
    if (heights.width() < 2 || heights.height() < 2)
        throw bad_request("{} x {} heights, fewer than 2 x 2", heights.width(),
                          heights.height());
    terrain.heights = std::move(heights);
    if (voids) *voids = voids_of(terrain.heights);
    fill_voids(terrain.heights, most_voids(voids), notes);
    return terrain;
}

// The mask of voids on the warped grid: 1 wherever a void contributes to a height.
Field<std::uint8_t> moved(DemGrid grid, const Field<std::uint8_t>& voids) {
    if (voids.empty()) return {};
    constexpr float kWeighsIn = 0.02f;
    std::copy(voids.begin(), voids.end(), grid.heights.begin());
    Notes ignored;
    const Field<float> weights = on_square_metres(grid, ignored).heights;
    Field<std::uint8_t> result(weights.width(), weights.height());
    std::transform(weights.begin(), weights.end(), result.begin(),
                   [](float weight) { return std::abs(weight) > kWeighsIn; });
    return result;
}

Terrain terrain_of_grid(const Source& source, Notes& notes, Field<std::uint8_t>* voids) {
    DemGrid grid = dem_grid(source, notes);
    const Field<std::uint8_t> in_file = voids_of(grid.heights);
    fill_voids(grid.heights, most_voids(voids), notes);
    Terrain terrain = on_square_metres(grid, notes);
    if (voids) *voids = moved(std::move(grid), in_file);
    return terrain;
}

// Runs a step whose errors do not name the file, and adds the file to them.
template <class Step>
Terrain about(const Source& source, const Step& step) {
    try {
        return step();
    } catch (const Error& error) {
        throw Error(error.code(),
                    fmt::format("{}: {}", source.path.string(), error.what()));
    }
}

}  // namespace

Terrain read_dem(const Source& source, std::string* note, Field<std::uint8_t>* voids) {
    const QuietGdal quiet;
    Notes notes;
    Terrain terrain;
    if (is_exr(source)) {
        Metadata metadata;
        Field<float> heights = read_exr(source.path, &metadata);
        terrain = about(source, [&] {
            return terrain_of_exr(std::move(heights), metadata, notes, voids);
        });
    } else {
        terrain = about(source, [&] { return terrain_of_grid(source, notes, voids); });
    }
    if (note) *note = fmt::format("{}", fmt::join(notes, "; "));
    return terrain;
}

std::optional<std::uint64_t> samples_of_dem(const Source& source) {
    const QuietGdal quiet;
    try {
        if (!is_exr(source)) return samples_of_grid(source);
    } catch (const Error&) {  // read_dem will say it
    }
    return std::nullopt;
}

}  // namespace cydonia
