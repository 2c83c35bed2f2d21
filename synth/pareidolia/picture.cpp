#include "synth/pareidolia/picture.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "field/error.h"
#include "field/image.h"
#include "field/parallel.h"
#include "field/svg.h"
#include "synth/pareidolia/lettering.h"
#include "synth/pareidolia/stencil.h"

namespace cydonia::pareidolia {
namespace {

constexpr int kRows = 16;  // at a time

template <class Value>
Field<float> each(const Field<Rgba8>& image, const Value& value) {
    Field<float> result(image.width(), image.height());
    parallel_for(image.height(), kRows, [&](int y) {
        std::ranges::transform(image.row(y), result.row(y).begin(), value);
    });
    return result;
}

float transparency(Rgba8 pixel) { return 1.0f - float(pixel[3]) / 255.0f; }

Field<float> as_read(const Field<Rgba8>& image, Reading reading) {
    return reading == Reading::kAlpha ? each(image, transparency)
                                      : each(image, grey_over_white);
}

// Stretches the values so that the threshold becomes a half; a threshold of a half
// changes nothing.
void put_at_half(Field<float>& lightness, double threshold) {
    if (threshold == 0.5) return;
    for (float& l : lightness)
        l = static_cast<float>(l < threshold
                                   ? 0.5 * l / threshold
                                   : 0.5 + 0.5 * (l - threshold) / (1.0 - threshold));
}

void finish(Field<float>& lightness, const ImageOptions& options) {
    if (options.reading == Reading::kDark) put_at_half(lightness, options.threshold);
    if (options.reading == Reading::kAlpha)  // lightness is transparency here
        put_at_half(lightness, 1.0 - options.threshold);
    if (options.invert)
        for (float& l : lightness) l = 1.0f - l;
}

Picture of_pixels(std::string name, Field<float> lightness) {
    const auto pixels = std::make_shared<const Field<float>>(std::move(lightness));
    Picture picture{
        std::move(name), double(pixels->width()), double(pixels->height()), true, {}};
    picture.lightness = [pixels](int width, int height) {
        return resized(*pixels, width, height);
    };
    return picture;
}

struct Pixels {
    int width, height;
};
constexpr Pixels kAny{16384, 16384};

// Draws the picture four times as fine as requested, but with at most `most` pixels.
template <class Draw>
auto supersampled(const Draw& draw, const ImageOptions& options, Pixels most = kAny) {
    return [draw, options, most](int width, int height) {
        constexpr int kFinest = 4096;
        const int finer = std::clamp(kFinest / std::max(width, height), 1, 4);
        Field<float> lightness = as_read(draw(std::min(finer * width, most.width),
                                              std::min(finer * height, most.height)),
                                         options.reading);
        finish(lightness, options);
        return resized(lightness, width, height);
    };
}

Picture of_text(const ImageOptions& options, Progress& progress) {
    const Lettering letters = lettering(options.text, options.font, progress);
    ImageOptions black_on_white;
    black_on_white.invert = options.invert;
    const auto draw = [svg = letters.svg](int width, int height) {
        return drawn_svg("text", svg, width, height, SvgEdges::kSmooth);
    };
    return {"text '" + options.text + "'", letters.width, letters.height, false,
            supersampled(
                draw, black_on_white,
                {static_cast<int>(letters.width), static_cast<int>(letters.height)})};
}

Picture of_photograph(const ImageOptions& options) {
    const Source& source = *options.target;
    Field<float> grey;
    if (is_svg(source)) {
        const auto [width, height] = page_size(source);
        const double scale = kStencilSide / std::max({width, height, 1.0});
        grey = each(read_svg(source, std::max(1, int(width * scale)),
                             std::max(1, int(height * scale)), SvgEdges::kSmooth),
                    grey_over_white);
    } else {
        grey = read_grey(source);
    }
    Field<float> drawn = stencil(grey, options.threshold);
    finish(drawn, options);
    return of_pixels(source.name(), std::move(drawn));
}

Picture of_drawing(const ImageOptions& options) {
    const Source source = *options.target;
    const auto [width, height] = page_size(source);
    if (width == 0.0)
        throw bad_request("{}: the drawing has no size; give its <svg> a viewBox",
                          source.name());
    const auto draw = [source](int w, int h) {
        return read_svg(source, w, h, SvgEdges::kSmooth);
    };
    return {source.name(), width, height, false, supersampled(draw, options)};
}

}  // namespace

Picture picture_of(const ImageOptions& options, Progress& progress) {
    if (!options.target) return of_text(options, progress);
    if (options.reading == Reading::kPhotograph) return of_photograph(options);
    if (is_svg(*options.target)) return of_drawing(options);
    Field<float> lightness = options.reading == Reading::kAlpha
                                 ? each(read_rgba(*options.target), transparency)
                                 : read_grey(*options.target);
    finish(lightness, options);
    return of_pixels(options.target->name(), std::move(lightness));
}

}  // namespace cydonia::pareidolia
