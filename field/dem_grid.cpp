#include <algorithm>
#include <cmath>
#include <limits>

#include "field/dem_grid.h"
#include "field/error.h"
#include "field/gdal.h"
#include "field/packaged.h"

namespace cydonia {
namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

// Formats that hold heights in a file of their own. VRT and similar formats open other
// files and addresses, so that only those that ship with the program are read.
constexpr const char* kDrivers[] = {
    "GTiff", "USGSDEM", "SDTS",     "SRTMHGT", "DTED", "AAIGrid", "GRASSASCIIGrid",
    "EHdr",  "ENVI",    "HFA",      "GSAG",    "GSBG", "GS7BG",   "SAGA",
    "PDS",   "PDS4",    "ISIS3",    "ISIS2",   "ACE2", "XYZ",     "JP2OpenJPEG",
    "PNG",   "JPEG",    "Terragen", nullptr};
constexpr const char* kPackagedDrivers[] = {"VRT", nullptr};

Dataset opened(const Source& source) {
    Dataset file(GDALDataset::Open(
        source.path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
        is_packaged_dem(source.path) ? kPackagedDrivers : kDrivers));
    if (!file) throw bad_request("not an elevation model: {}", QuietGdal::message());
    const int width = file->GetRasterXSize(), height = file->GetRasterYSize();
    if (file->GetRasterCount() < 1) throw bad_request("it holds no raster");
    if (width < 2 || height < 2)
        throw bad_request("{} x {} heights, fewer than 2 x 2", width, height);
    if (width > kLargestSide || height > kLargestSide)
        throw bad_request("{} x {} heights, more than {} x {}", width, height,
                          kLargestSide, kLargestSide);
    if (GDALDataTypeIsComplex(file->GetRasterBand(1)->GetRasterDataType()))
        throw bad_request("its values are complex numbers, not heights");
    return file;
}

// Values that files hold where nothing was measured, whether they declare them or not.
bool is_void(float stored) {
    return !std::isfinite(stored) || std::abs(stored) > 1e30f || stored == -32768.0f ||
           stored == -32767.0f || stored == -9999.0f;
}

// The length of one unit of the heights, in metres.
double unit_of_heights(GDALRasterBand& band, const OGRSpatialReference& plane,
                       Notes& notes) {
    std::string unit = band.GetUnitType();
    std::transform(unit.begin(), unit.end(), unit.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (unit.empty())
        return plane.IsEmpty() ? 1.0 : plane.GetTargetLinearUnits("VERT_CS", nullptr);
    const auto is_one_of = [&](std::initializer_list<const char*> names) {
        return std::find(names.begin(), names.end(), unit) != names.end();
    };
    if (is_one_of({"m", "metre", "metres", "meter", "meters"})) return 1.0;
    if (is_one_of({"us survey foot", "us-ft", "ftus", "foot_us", "us survey feet"}))
        return 1200.0 / 3937.0;
    if (is_one_of({"ft", "foot", "feet", "international foot"})) return 0.3048;
    if (is_one_of({"km", "kilometre", "kilometer"})) return 1000.0;
    if (is_one_of({"cm", "centimetre", "centimeter"})) return 0.01;
    notes.push_back(fmt::format("its unit of height, '{}', was taken for metres", unit));
    return 1.0;
}

Field<float> stored_values(GDALRasterBand& band) {
    Field<float> values(band.GetXSize(), band.GetYSize());
    Field<std::uint8_t> mask(band.GetXSize(), band.GetYSize());
    const auto read = [&](GDALRasterBand& from, void* to, GDALDataType type) {
        return from.RasterIO(GF_Read, 0, 0, values.width(), values.height(), to,
                             values.width(), values.height(), type, 0, 0,
                             nullptr) == CE_None;
    };
    if (!read(band, values.data(), GDT_Float32) ||
        !read(*band.GetMaskBand(), mask.data(), GDT_Byte))
        throw bad_request("truncated or damaged: {}", QuietGdal::message());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (mask[i] == 0 || is_void(values[i])) values[i] = kVoid;
    return values;
}

Field<float> heights_in_metres(GDALDataset& file, const OGRSpatialReference& plane,
                               Notes& notes) {
    GDALRasterBand& band = *file.GetRasterBand(1);
    if (file.GetRasterCount() > 1)
        notes.push_back(
            fmt::format("of its {} bands the first was used", file.GetRasterCount()));
    Field<float> heights = stored_values(band);
    const double metres = unit_of_heights(band, plane, notes);
    const double scale = band.GetScale() * metres, offset = band.GetOffset() * metres;
    if (!std::isfinite(scale) || !std::isfinite(offset) || scale == 0.0)
        throw bad_request("its heights have a scale of {} and an offset of {}",
                          band.GetScale(), band.GetOffset());
    if (scale != 1.0 || offset != 0.0)
        for (float& height : heights)
            height = static_cast<float>(height * scale + offset);
    return heights;
}

// The rows of a file may run from south to north.
void put_north_up(DemGrid& grid) {
    auto& t = grid.transform;
    if (t[5] < 0.0) return;
    for (int top = 0, bottom = grid.heights.height() - 1; top < bottom; ++top, --bottom)
        std::ranges::swap_ranges(grid.heights.row(top), grid.heights.row(bottom));
    t[3] += t[5] * grid.heights.height();
    t[5] = -t[5];
}

std::array<double, 6> transform_of(GDALDataset& file, const OGRSpatialReference& plane) {
    std::array<double, 6> t{};
    if (file.GetGeoTransform(t.data()) != CE_None)
        throw bad_request(
            "it has no coordinates, so the size of its cells is unknown; give it one "
            "with gdal_translate -a_ullr");
    if (!std::all_of(t.begin(), t.end(), [](double v) { return std::isfinite(v); }) ||
        t[1] == 0.0 || t[5] == 0.0)
        throw bad_request("its coordinates are not finite or its cells have no size");
    if (t[2] != 0.0 || t[4] != 0.0 || t[1] < 0.0)
        throw bad_request(
            "its grid is turned or mirrored; put north up with gdalwarp first");
    if (plane.IsEmpty() && std::abs(t[5]) < 0.05 && std::abs(t[0]) <= 360.0 &&
        std::abs(t[3]) <= 90.0)
        throw bad_request(
            "it names no coordinate system and its coordinates look like degrees; name "
            "it with gdal_translate -a_srs");
    return t;
}

OGRSpatialReference plane_of(GDALDataset& file) {
    OGRSpatialReference plane;
    if (const OGRSpatialReference* named = file.GetSpatialRef()) plane = *named;
    plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return plane;
}

}  // namespace

std::uint64_t samples_of_grid(const Source& source) {
    const Dataset file = opened(source);
    return std::uint64_t(file->GetRasterXSize()) * std::uint64_t(file->GetRasterYSize());
}

DemGrid dem_grid(const Source& source, Notes& notes) {
    const Dataset file = opened(source);
    DemGrid grid;
    grid.plane = plane_of(*file);
    grid.transform = transform_of(*file, grid.plane);
    grid.heights = heights_in_metres(*file, grid.plane, notes);
    if (grid.plane.IsCompound()) grid.plane.StripVertical();
    put_north_up(grid);
    return grid;
}

}  // namespace cydonia
