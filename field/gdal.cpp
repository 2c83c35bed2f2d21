#include "field/gdal.h"

#include "field/error.h"

namespace cydonia {
namespace {

void transfer(GDALDataset& dataset, GDALRWFlag direction, float* values) {
    const int width = dataset.GetRasterXSize(), height = dataset.GetRasterYSize();
    if (dataset.GetRasterBand(1)->RasterIO(direction, 0, 0, width, height, values, width,
                                           height, GDT_Float32, 0, 0, nullptr) != CE_None)
        throw failure("GDAL: {}", QuietGdal::message());
}

}  // namespace

Dataset memory_dataset(int width, int height, GDALDataType type) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    Dataset dataset(driver->Create("", width, height, 1, type, nullptr));
    if (!dataset) throw failure("GDAL: {}", QuietGdal::message());
    return dataset;
}

void store(const Field<float>& values, GDALDataset& dataset) {
    transfer(dataset, GF_Write, const_cast<float*>(values.data()));  // only reads them
}

void load(GDALDataset& dataset, Field<float>& values) {
    transfer(dataset, GF_Read, values.data());
}

}  // namespace cydonia
