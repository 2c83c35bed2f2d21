#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <ogr_spatialref.h>

#include <atomic>
#include <string_view>

#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/gdal.h"

namespace cydonia {
namespace {

// A file in memory, gone with this: so that only write_text meets the disk, where GDAL
// reports a full one on some paths only.
class MemoryFile {
  public:
    MemoryFile() {
        static std::atomic<int> count = 0;
        name_ = fmt::format("/vsimem/cydonia/{}.tif", count++);
    }
    ~MemoryFile() { VSIUnlink(name_.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const char* name() const { return name_.c_str(); }
    std::string_view bytes() const {
        vsi_l_offset size = 0;
        const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
        return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
    }

  private:
    std::string name_;
};

OGRSpatialReference local_metres() {
    OGRSpatialReference plane;
    plane.SetLocalCS("Cydonia");
    plane.SetLinearUnits("metre", 1.0);
    return plane;
}

bool encoded(const Terrain& terrain, const char* name) {
    const char* options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "BIGTIFF=IF_SAFER",
                             nullptr};
    const int width = terrain.heights.width(), height = terrain.heights.height();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    const Dataset file(
        driver->Create(name, width, height, 1, GDT_Float32, const_cast<char**>(options)));
    if (!file) return false;
    double north_west[6] = {0.0, terrain.spacing, 0.0, terrain.depth(),
                            0.0, -terrain.spacing};
    const OGRSpatialReference plane = local_metres();
    file->SetGeoTransform(north_west);
    file->SetSpatialRef(&plane);
    file->GetRasterBand(1)->SetUnitType("m");
    store(terrain.heights, *file);
    file->FlushCache(true);
    return CPLGetLastErrorType() < CE_Failure;
}

}  // namespace

void write_geotiff(const std::filesystem::path& path, const Terrain& terrain) {
    const QuietGdal quiet;
    const MemoryFile file;
    if (!encoded(terrain, file.name()))
        throw failure("cannot write {}: {}", path.string(), QuietGdal::message());
    write_text(path, file.bytes());
}

}  // namespace cydonia
