#pragma once

#include <filesystem>

#include "field/source.h"
#include "field/terrain.h"

namespace cydonia {

// An elevation model through GDAL (GeoTIFF, USGS DEM, SDTS, HGT, ...). Also our own
// terrain.exr. Voids are filled by interpolation, non-square or geographic cells are
// warped to square metres, or the file is refused with the reason; `note` receives what
// was done.
Terrain read_dem(const Source& source, std::string* note = nullptr);

// 32-bit float GeoTIFF in local metres, origin at the south-west corner.
void write_geotiff(const std::filesystem::path& path, const Terrain& terrain);

}  // namespace cydonia
