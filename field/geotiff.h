#pragma once

#include <ogr_spatialref.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "field/gdal.h"

namespace cydonia {

// Internal to field/: what all files that GDAL writes for us have in common.

// The land's own plane.
OGRSpatialReference local_metres();

// A file in memory, gone with this: so that only write_text meets the disk, where GDAL
// reports a full one on some paths only.
class MemoryFile {
  public:
    MemoryFile();
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const char* name() const { return name_.c_str(); }
    std::string_view bytes() const;

  private:
    std::string name_;
};

// A new file for metres, its north-west corner `west` and `north` metres from the land's
// south-west corner. `options` are those of GDAL's driver besides the compression. Null
// when it cannot be made.
Dataset new_geotiff(const char* name, int width, int height, double spacing, double west,
                    double north, std::initializer_list<const char*> options);

}  // namespace cydonia
