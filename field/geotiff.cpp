#include "field/geotiff.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include <atomic>
#include <vector>

#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia {
namespace {

bool encoded(const Terrain& terrain, const char* name) {
    const int width = terrain.heights.width(), height = terrain.heights.height();
    const Dataset file = new_geotiff(name, width, height, terrain.spacing, 0.0,
                                     terrain.depth(), {"BIGTIFF=IF_SAFER"});
    if (!file) return false;
    store(terrain.heights, *file);
    file->FlushCache(true);
    return CPLGetLastErrorType() < CE_Failure;
}

}  // namespace

OGRSpatialReference local_metres() {
    OGRSpatialReference plane;
    plane.SetLocalCS("Cydonia");
    plane.SetLinearUnits("metre", 1.0);
    return plane;
}

MemoryFile::MemoryFile() {
    static std::atomic<int> count = 0;
    name_ = fmt::format("/vsimem/cydonia/{}.tif", count++);
}

MemoryFile::~MemoryFile() { VSIUnlink(name_.c_str()); }

std::string_view MemoryFile::bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
}

Dataset new_geotiff(const char* name, int width, int height, double spacing, double west,
                    double north, std::initializer_list<const char*> options) {
    std::vector<const char*> all{"COMPRESS=DEFLATE", "PREDICTOR=3"};
    all.insert(all.end(), options.begin(), options.end());
    all.push_back(nullptr);
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    Dataset file(driver->Create(name, width, height, 1, GDT_Float32,
                                const_cast<char**>(all.data())));
    if (!file) return file;
    double north_west[6] = {west, spacing, 0.0, north, 0.0, -spacing};
    const OGRSpatialReference plane = local_metres();
    file->SetGeoTransform(north_west);
    file->SetSpatialRef(&plane);
    file->GetRasterBand(1)->SetUnitType("m");
    return file;
}

void write_geotiff(const std::filesystem::path& path, const Terrain& terrain) {
    const QuietGdal quiet;
    const MemoryFile file;
    if (!encoded(terrain, file.name()))
        throw failure("cannot write {}: {}", path.string(), QuietGdal::message());
    write_text(path, file.bytes());
}

}  // namespace cydonia
