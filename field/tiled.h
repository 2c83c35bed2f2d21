#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "field/field.h"
#include "field/image.h"

namespace cydonia {

// Heights too many for memory, written part by part into one file.
class TiledFile {
  public:
    static constexpr int kBlock = 256;  // samples a side of what the file is made of

    virtual ~TiledFile() = default;
    // The part whose north-west sample is (x, y): multiples of kBlock, as its size is but
    // where it ends at the file's edge. Each block once. Throws failure().
    virtual void write(int x, int y, const Field<float>& heights) = 0;
    // After the last part. Throws failure(), also for what could not be written before.
    virtual void close() = 0;
};

struct TiledShape {
    int width = 0, height = 0;  // samples
    double spacing = 1.0;       // metres
};

// The same formats as write_geotiff() and write_exr() of heights. To be called within
// write_atomically().
std::unique_ptr<TiledFile> tiled_geotiff(const std::filesystem::path& path,
                                         const TiledShape& shape);
std::unique_ptr<TiledFile> tiled_exr(const std::filesystem::path& path,
                                     const TiledShape& shape, const Metadata& metadata);

// One part in a GeoTIFF of its own, where it lies on the whole; `key` says what it was
// made from. Written to a temporary name and renamed.
void write_tile(const std::filesystem::path& path, const Field<float>& heights, int x,
                int y, const TiledShape& whole, const std::string& key);
// Nothing when the file is missing, of another key or size, or damaged.
std::optional<Field<float>> read_tile(const std::filesystem::path& path, int width,
                                      int height, const std::string& key);
// The same without its heights.
bool holds_tile(const std::filesystem::path& path, int width, int height,
                const std::string& key);

}  // namespace cydonia
