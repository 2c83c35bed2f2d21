#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "field/error.h"
#include "field/files.h"
#include "field/geotiff.h"
#include "field/tiled.h"

namespace cydonia {
namespace fs = std::filesystem;
namespace {

constexpr const char* kKey = "CYDONIA_KEY";

Error unwritable(const std::string& name) {
    return failure("cannot write {}: {}", name, QuietGdal::message());
}

// The offset of a block according to the directory; none when the directory has none.
std::optional<std::uintmax_t> end_of_block(GDALRasterBand& band, int column, int row) {
    std::uintmax_t end = 0;
    for (const char* part : {"OFFSET", "SIZE"}) {
        const std::string name = fmt::format("BLOCK_{}_{}_{}", part, column, row);
        const char* text = band.GetMetadataItem(name.c_str(), "TIFF");
        std::uintmax_t value = 0;
        if (!text) return std::nullopt;
        std::from_chars(text, text + std::string_view(text).size(), value);
        end += value;
    }
    return end;
}

// GDAL does not report every full disk, so that what it wrote is compared with the file.
bool complete(const fs::path& path) {
    const Dataset file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
    std::error_code none;
    const std::uintmax_t size = fs::file_size(path, none);
    if (!file || none) return false;
    GDALRasterBand& band = *file->GetRasterBand(1);
    const auto blocks = [](int samples) {
        return (samples + TiledFile::kBlock - 1) / TiledFile::kBlock;
    };
    for (int row = 0; row < blocks(file->GetRasterYSize()); ++row)
        for (int column = 0; column < blocks(file->GetRasterXSize()); ++column) {
            const auto end = end_of_block(band, column, row);
            if (!end || *end > size) return false;
        }
    return true;
}

class TiledGeotiff final : public TiledFile {
  public:
    TiledGeotiff(const fs::path& path, const TiledShape& shape) : path_(path) {
        const std::string side = fmt::format("{}", kBlock);
        file_ = new_geotiff(path.c_str(), shape.width, shape.height, shape.spacing, 0.0,
                            shape.spacing * shape.height,
                            {"TILED=YES", ("BLOCKXSIZE=" + side).c_str(),
                             ("BLOCKYSIZE=" + side).c_str(), "BIGTIFF=IF_SAFER"});
        if (!file_) throw unwritable(path_.string());
    }

    void write(int x, int y, const Field<float>& heights) override {
        GDALRasterBand& band = *file_->GetRasterBand(1);
        const int width = heights.width(), height = heights.height();
        const CPLErr stored = band.RasterIO(
            GF_Write, x, y, width, height, const_cast<float*>(heights.data()), width,
            height, GDT_Float32, 0, 0, nullptr);  // only reads them
        if (stored != CE_None || band.FlushCache(false) != CE_None)
            throw unwritable(path_.string());
    }

    void close() override {
        file_.reset();
        if (CPLGetLastErrorType() >= CE_Failure || !complete(path_))
            throw unwritable(path_.string());
    }

  private:
    const QuietGdal quiet_;
    fs::path path_;
    Dataset file_;
};

// Opens the file; null unless it is the tile that is asked for.
Dataset tile_file(const fs::path& path, int width, int height, const std::string& key) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return nullptr;
    Dataset file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
    if (!file || file->GetRasterXSize() != width || file->GetRasterYSize() != height ||
        file->GetRasterCount() != 1)
        return nullptr;
    const char* kept = file->GetMetadataItem(kKey);
    return kept && kept == key ? std::move(file) : nullptr;
}

bool encoded(const char* name, const Field<float>& heights, int x, int y,
             const TiledShape& whole, const std::string& key) {
    const Dataset file = new_geotiff(
        name, heights.width(), heights.height(), whole.spacing, x * whole.spacing,
        (whole.height - y) * whole.spacing, {"BIGTIFF=IF_SAFER"});
    if (!file) return false;
    file->SetMetadataItem(kKey, key.c_str());
    store(heights, *file);
    file->FlushCache(true);
    return CPLGetLastErrorType() < CE_Failure;
}

}  // namespace

std::unique_ptr<TiledFile> tiled_geotiff(const fs::path& path, const TiledShape& shape) {
    return std::make_unique<TiledGeotiff>(path, shape);
}

void write_tile(const fs::path& path, const Field<float>& heights, int x, int y,
                const TiledShape& whole, const std::string& key) {
    const QuietGdal quiet;
    const MemoryFile file;
    if (!encoded(file.name(), heights, x, y, whole, key)) throw unwritable(path.string());
    write_text(path, file.bytes());
}

std::optional<Field<float>> read_tile(const fs::path& path, int width, int height,
                                      const std::string& key) {
    const QuietGdal quiet;
    const Dataset file = tile_file(path, width, height, key);
    if (!file) return std::nullopt;
    Field<float> heights(width, height);
    try {
        load(*file, heights);
    } catch (const Error&) {
        return std::nullopt;
    }
    return heights;
}

bool holds_tile(const fs::path& path, int width, int height, const std::string& key) {
    const QuietGdal quiet;
    return tile_file(path, width, height, key) != nullptr;
}

}  // namespace cydonia
