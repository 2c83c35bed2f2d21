#include <OpenImageIO/imageio.h>

#include "field/error.h"
#include "field/files.h"
#include "render/passes/passes.h"

namespace cydonia::render {
namespace {

// Red, green, blue and white, x and y each, of the ACES document S-2014-004.
constexpr float kAcesCgChromaticities[8] = {0.713f, 0.293f, 0.165f,   0.830f,
                                            0.128f, 0.044f, 0.32168f, 0.33767f};

struct Part {
    OIIO::ImageSpec spec;
    const float* values;
};

Part part(const std::string& name, const std::vector<std::string>& channels, bool half,
          const float* values, int width, int height, const Metadata& metadata) {
    OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()),
                         half ? OIIO::TypeHalf : OIIO::TypeFloat);
    spec.channelnames = channels;
    spec["oiio:subimagename"] = name;
    spec["compression"] = "zips";  // a line at a time, as compositors read
    spec["DateTime"] = "";         // the same values give the same bytes on any day
    for (const auto& [key, value] : metadata) spec[key] = value;
    return {std::move(spec), values};
}

// OpenImageIO writes files of several parts to disk only, and does not notice every write
// that fails: what cannot be read back was not written.
bool is_whole(const std::filesystem::path& file, const std::vector<Part>& parts) {
    const auto input = OIIO::ImageInput::open(file.string());
    for (std::size_t i = 0; input && i < parts.size(); ++i) {
        const OIIO::ImageSpec& spec = parts[i].spec;
        std::vector<float> row(static_cast<std::size_t>(spec.width) * spec.nchannels);
        if (!input->seek_subimage(static_cast<int>(i), 0) ||
            !input->read_scanline(spec.height - 1, 0, OIIO::TypeFloat, row.data()))
            return false;
    }
    return input != nullptr;
}

void write(const std::filesystem::path& file, const std::vector<Part>& parts) {
    std::vector<OIIO::ImageSpec> specs;
    for (const Part& p : parts) specs.push_back(p.spec);
    const std::string name = file.string();
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output) throw failure("cannot write {}: {}", name, OIIO::geterror());
    bool good = output->open(name, static_cast<int>(specs.size()), specs.data());
    for (std::size_t i = 0; good && i < parts.size(); ++i) {
        if (i > 0) good = output->open(name, specs[i], OIIO::ImageOutput::AppendSubimage);
        good = good && output->write_image(OIIO::TypeFloat, parts[i].values);
    }
    if (!good || !output->close())
        throw failure("cannot write {}: {}", name, output->geterror());
    if (!is_whole(file, parts)) throw failure("{} could not be written whole", name);
}

}  // namespace

void write_passes(const std::filesystem::path& path, const Field<Rgb>& beauty,
                  const std::vector<PassLayer>& layers, int width, int height,
                  const Metadata& metadata) {
    if (!beauty.empty() && (beauty.width() != width || beauty.height() != height))
        throw bad_request("a frame of {}x{} pixels does not fit passes of {}x{}",
                          beauty.width(), beauty.height(), width, height);
    std::vector<Part> parts;
    if (!beauty.empty()) {
        parts.push_back(part("beauty", {"R", "G", "B"}, true, beauty.data()->data(),
                             width, height, metadata));
        parts.back().spec.attribute("chromaticities",
                                    OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                                    kAcesCgChromaticities);
    }
    for (const PassLayer& layer : layers) {
        if (layer.values.size() != layer.channels.size() *
                                       static_cast<std::size_t>(width) *
                                       static_cast<std::size_t>(height))
            throw bad_request("the pass {} does not have {}x{} pixels", layer.name, width,
                              height);
        parts.push_back(part(layer.name, layer.channels, layer.half, layer.values.data(),
                             width, height, metadata));
    }
    if (parts.empty()) return;
    write_atomically(path,
                     [&](const std::filesystem::path& file) { write(file, parts); });
}

}  // namespace cydonia::render
