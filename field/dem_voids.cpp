#include <cpl_error.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>

#include "field/dem_grid.h"
#include "field/error.h"
#include "field/gdal.h"

namespace cydonia {
namespace {

// Averages over 3 x 3 cells, among the filled ones only, to remove the rays that GDAL's
// search from each void leaves.
constexpr int kSmoothings = 3;

// A mask that is not zero where a height is known, for GDALFillNodata.
Dataset mask_of(const Field<float>& heights) {
    Field<float> known(heights.width(), heights.height());
    std::transform(heights.begin(), heights.end(), known.begin(),
                   [](float height) { return std::isfinite(height) ? 255.0f : 0.0f; });
    Dataset mask = memory_dataset(heights.width(), heights.height(), GDT_Byte);
    store(known, *mask);
    return mask;
}

std::size_t count_voids(const Field<float>& heights) {
    return static_cast<std::size_t>(std::count_if(
        heights.begin(), heights.end(), [](float h) { return !std::isfinite(h); }));
}

}  // namespace

Field<std::uint8_t> voids_of(const Field<float>& heights) {
    if (count_voids(heights) == 0) return {};
    Field<std::uint8_t> voids(heights.width(), heights.height());
    std::transform(heights.begin(), heights.end(), voids.begin(),
                   [](float height) { return !std::isfinite(height); });
    return voids;
}

void fill_voids(Field<float>& heights, double most, Notes& notes) {
    const std::size_t voids = count_voids(heights);
    if (voids == 0) return;
    const double share = double(voids) / double(heights.size());
    if (share > most)
        throw bad_request(
            "{:.1f}% of its cells have no height; at most {:.0f}% are interpolated, cut "
            "out a part with fewer",
            100.0 * share, 100.0 * most);

    const Dataset filled = memory_dataset(heights.width(), heights.height(), GDT_Float32);
    const Dataset mask = mask_of(heights);
    store(heights, *filled);
    const double reach = std::hypot(heights.width(), heights.height());
    const char* options[] = {"TEMP_FILE_DRIVER=MEM", nullptr};
    if (GDALFillNodata(filled->GetRasterBand(1), mask->GetRasterBand(1), reach, 0,
                       kSmoothings, const_cast<char**>(options), nullptr,
                       nullptr) != CE_None)
        throw bad_request("its voids cannot be filled: {}", QuietGdal::message());
    load(*filled, heights);
    if (count_voids(heights) > 0)
        throw bad_request("{} of its cells have no height and too few neighbours", voids);
    notes.push_back(fmt::format("{} cells without a height ({:.2g}%) were interpolated",
                                voids, 100.0 * share));
}

}  // namespace cydonia
