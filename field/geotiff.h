#pragma once

#include <ogr_spatialref.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "field/gdal.h"

namespace cydonia {

// Internal to field/: what all files that we write through GDAL have in common.

// The coordinate system of a terrain: metres in a plane of its own.
OGRSpatialReference local_metres();

// A file in memory that lasts as long as this object. GDAL does not report a full disk on
// all of its paths, so that only write_text() writes to the disk.
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

// Makes a new file of heights in metres whose north-west corner lies `west` and `north`
// metres from the land's south-west corner. `options` are passed to GDAL's driver besides
// the compression. Null when the file cannot be made.
Dataset new_geotiff(const char* name, int width, int height, double spacing, double west,
                    double north, std::initializer_list<const char*> options);

}  // namespace cydonia
