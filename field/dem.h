#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "field/field.h"
#include "field/source.h"
#include "field/terrain.h"

namespace cydonia {

// Reads an elevation model through GDAL (GeoTIFF, USGS DEM, SDTS, HGT and others), or our
// own terrain.exr. Voids are filled by interpolation, and cells that are not square or
// are geographic are warped to square metres; a file for which that fails is refused with
// the reason. `note` receives what was done. `voids` receives a mask of the result's
// shape, 1 where heights were interpolated, or an empty one; when it is given, any share
// of voids is accepted.
Terrain read_dem(const Source& source, std::string* note = nullptr,
                 Field<std::uint8_t>* voids = nullptr);

// The number of heights that the file's header promises; none when the header does not
// tell.
std::optional<std::uint64_t> samples_of_dem(const Source& source);

// Writes a 32-bit float GeoTIFF in local metres, with its origin at the south-west
// corner.
void write_geotiff(const std::filesystem::path& path, const Terrain& terrain);

}  // namespace cydonia
