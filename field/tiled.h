#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "field/field.h"
#include "field/image.h"

namespace cydonia {

// A file of heights that are too many for memory and are written part by part.
class TiledFile {
  public:
    static constexpr int kBlock = 256;  // samples a side of what the file is made of

    virtual ~TiledFile() = default;
    // Writes the part whose north-west sample is (x, y). These are multiples of kBlock,
    // and so is the part's size, unless it ends at the file's edge. Each block is written
    // once. Throws failure().
    virtual void write(int x, int y, const Field<float>& heights) = 0;
    // Must be called after the last part. Throws failure(), also for parts that could not
    // be written before.
    virtual void close() = 0;
};

struct TiledShape {
    int width = 0, height = 0;  // samples
    double spacing = 1.0;       // metres
};

// The formats of write_geotiff() and write_exr(). Call these within write_atomically().
std::unique_ptr<TiledFile> tiled_geotiff(const std::filesystem::path& path,
                                         const TiledShape& shape);
std::unique_ptr<TiledFile> tiled_exr(const std::filesystem::path& path,
                                     const TiledShape& shape, const Metadata& metadata);

// Writes one part to a GeoTIFF of its own that says where it lies on the whole. `key`
// identifies what it was made from. The file is written to a temporary name and renamed.
void write_tile(const std::filesystem::path& path, const Field<float>& heights, int x,
                int y, const TiledShape& whole, const std::string& key);
// Reads such a file; nothing when it is missing, damaged, or of another key or size.
std::optional<Field<float>> read_tile(const std::filesystem::path& path, int width,
                                      int height, const std::string& key);
// Whether read_tile() would find the tile, by its header.
bool holds_tile(const std::filesystem::path& path, int width, int height,
                const std::string& key);

}  // namespace cydonia
