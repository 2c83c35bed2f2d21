#include "synth/pareidolia/target.h"

#include <algorithm>
#include <cctype>

#include "field/error.h"
#include "field/image.h"
#include "field/strokes.h"
#include "field/svg.h"

namespace cydonia::pareidolia {
namespace {

Field<float> stretched(const Source& source, int width, int height, Progress& progress) {
    if (is_svg(source)) return read_grey_at(source, width, height);
    const Field<float> image = read_grey(source);
    if (image.width() == width && image.height() == height) return image;
    progress.note(fmt::format("{}: {}x{} pixels stretched over {}x{} cells",
                              source.name(), image.width(), image.height(), width,
                              height));
    return resized(image, width, height);
}

}  // namespace

Field<std::uint8_t> shadow_target(const ImageOptions& image, int width, int height,
                                  Progress& progress) {
    const Source& source = image.target.value();
    const Field<float> grey = stretched(source, width, height, progress);
    Field<std::uint8_t> target(width, height);
    std::transform(grey.begin(), grey.end(), target.begin(),
                   [](float g) { return static_cast<std::uint8_t>(g < 0.5f); });
    const auto dark = std::count(target.begin(), target.end(), 1);
    if (dark == 0)
        throw bad_request(
            "{}: no shadow in the target: draw what should be dark in black on white, at "
            "least a cell (1/{} of its width) thick",
            source.name(), width);
    if (dark == static_cast<std::ptrdiff_t>(target.size()))
        throw bad_request(
            "{}: the target is all shadow: leave light ground around the image for its "
            "casters",
            source.name());
    return target;
}

std::string image_name(const ImageOptions& image) {
    std::string name = image.target.value().path.stem().string();
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_'; }, '_');
    return name.empty() ? "image" : name;
}

}  // namespace cydonia::pareidolia
