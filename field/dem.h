#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "field/field.h"
#include "field/source.h"
#include "field/terrain.h"

namespace cydonia {

// An elevation model through GDAL (GeoTIFF, USGS DEM, SDTS, HGT, ...). Also our own
// terrain.exr. Voids are filled by interpolation, non-square or geographic cells are
// warped to square metres, or the file is refused with the reason; `note` receives what
// was done. `voids` receives 1 where that was interpolated (the result's shape; empty
// when nothing was) and allows for any share of it.
Terrain read_dem(const Source& source, std::string* note = nullptr,
                 Field<std::uint8_t>* voids = nullptr);

// How many heights its header promises; none when that cannot be told beforehand.
std::optional<std::uint64_t> samples_of_dem(const Source& source);

// 32-bit float GeoTIFF in local metres, origin at the south-west corner.
void write_geotiff(const std::filesystem::path& path, const Terrain& terrain);

}  // namespace cydonia
