#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstring>

#include "field/error.h"
#include "field/tiled.h"

namespace cydonia {
namespace {

class TiledExr final : public TiledFile {
  public:
    TiledExr(const std::filesystem::path& path, const TiledShape& shape,
             const Metadata& metadata)
        : path_(path.string()),
          disk_(path_, OIIO::Filesystem::IOProxy::Write),
          output_(OIIO::ImageOutput::create("openexr")) {
        OIIO::ImageSpec spec(shape.width, shape.height, 1, OIIO::TypeFloat);
        spec.channelnames = {"Y"};
        spec.tile_width = spec.tile_height = kBlock;
        spec["compression"] = "zip";
        spec["openexr:lineOrder"] = "randomY";  // else blocks wait in memory for others
        spec["DateTime"] = "";  // the same values give the same bytes on any day
        for (const auto& [name, value] : metadata) spec[name] = value;
        if (!disk_.opened() || !output_) throw unwritable();
        output_->set_ioproxy(&disk_);
        if (!output_->open(path_, spec)) throw unwritable();
    }

    void write(int x, int y, const Field<float>& heights) override {
        if (!output_->write_tiles(x, x + heights.width(), y, y + heights.height(), 0, 1,
                                  OIIO::TypeFloat, heights.data()))
            throw unwritable();
    }

    void close() override {
        // The last bytes meet the disk when they are flushed.
        if (!output_->close() || std::fflush(disk_.handle()) != 0 ||
            std::ferror(disk_.handle()))
            throw unwritable();
        disk_.close();
    }

  private:
    Error unwritable() const {
        std::string reason = output_ ? output_->geterror() : OIIO::geterror();
        if (reason.empty()) reason = std::strerror(errno);
        return failure("cannot write {}: {}", path_, reason);
    }

    std::string path_;
    OIIO::Filesystem::IOFile disk_;
    std::unique_ptr<OIIO::ImageOutput> output_;
};

}  // namespace

std::unique_ptr<TiledFile> tiled_exr(const std::filesystem::path& path,
                                     const TiledShape& shape, const Metadata& metadata) {
    return std::make_unique<TiledExr>(path, shape, metadata);
}

}  // namespace cydonia
