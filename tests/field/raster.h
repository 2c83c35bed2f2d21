#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "field/gdal.h"
#include "tests/field/temporary_folder.h"

namespace cydonia {

// Writes a file through GDAL, independently of our own writers.
struct Raster {
    int width = 0, height = 0;
    std::vector<std::vector<float>> bands;  // row-major
    std::array<double, 6> transform{};      // all zero: none
    const char* plane = nullptr;            // "EPSG:4326"
    GDALDataType type = GDT_Float32;
    double no_data = std::numeric_limits<double>::infinity();  // infinite: none
    const char* unit = "";
    double scale = 1.0, offset = 0.0;
};

inline Dataset create(const char* driver, const char* name, const Raster& raster,
                      const std::vector<const char*>& options) {
    auto terminated = options;
    terminated.push_back(nullptr);
    return Dataset(GetGDALDriverManager()->GetDriverByName(driver)->Create(
        name, raster.width, raster.height, int(raster.bands.size()), raster.type,
        const_cast<char**>(terminated.data())));
}

inline void describe(GDALDataset& dataset, const Raster& raster) {
    auto transform = raster.transform;
    if (transform != std::array<double, 6>{}) dataset.SetGeoTransform(transform.data());
    if (raster.plane) {
        OGRSpatialReference plane;
        plane.SetFromUserInput(raster.plane);
        dataset.SetSpatialRef(&plane);
    }
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    if (!std::isinf(raster.no_data)) band.SetNoDataValue(raster.no_data);
    if (*raster.unit) band.SetUnitType(raster.unit);
    if (raster.scale != 1.0) band.SetScale(raster.scale);
    if (raster.offset != 0.0) band.SetOffset(raster.offset);
}

inline std::filesystem::path write_tiff(const std::filesystem::path& path,
                                        const Raster& raster,
                                        const std::vector<const char*>& options = {}) {
    const QuietGdal quiet;
    const Dataset dataset = create("GTiff", path.c_str(), raster, options);
    describe(*dataset, raster);
    for (std::size_t i = 0; i < raster.bands.size(); ++i)
        EXPECT_EQ(dataset->GetRasterBand(int(i) + 1)
                      ->RasterIO(GF_Write, 0, 0, raster.width, raster.height,
                                 const_cast<float*>(raster.bands[i].data()), raster.width,
                                 raster.height, GDT_Float32, 0, 0, nullptr),
                  CE_None);
    return path;
}

// The same through a driver that can only copy: PNG, JPEG, AAIGrid.
inline std::filesystem::path write_copy(const std::filesystem::path& path,
                                        const char* driver, Raster raster) {
    const auto tiff = write_tiff(path.string() + ".copied", raster);
    const QuietGdal quiet;
    const Dataset from(GDALDataset::Open(tiff.c_str()));
    const Dataset copy(GetGDALDriverManager()->GetDriverByName(driver)->CreateCopy(
        path.c_str(), from.get(), FALSE, nullptr, nullptr, nullptr));
    EXPECT_TRUE(copy);
    std::filesystem::remove(tiff);
    return path;
}

// Stored values of a band, as an independent reader sees them.
inline std::vector<float> band_of(const std::filesystem::path& path, int band = 1) {
    const QuietGdal quiet;
    const Dataset dataset(GDALDataset::Open(path.c_str()));
    if (!dataset) return {};
    const int width = dataset->GetRasterXSize(), height = dataset->GetRasterYSize();
    std::vector<float> values(std::size_t(width) * std::size_t(height));
    EXPECT_EQ(dataset->GetRasterBand(band)->RasterIO(GF_Read, 0, 0, width, height,
                                                     values.data(), width, height,
                                                     GDT_Float32, 0, 0, nullptr),
              CE_None);
    return values;
}

}  // namespace cydonia
