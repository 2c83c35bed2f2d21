#include "synth/dem/dem.h"

#include <algorithm>
#include <utility>

#include "field/dem.h"
#include "field/error.h"
#include "field/sampled.h"

namespace cydonia::dem {
namespace {

// "5120 x 4000 m"
std::string size_text(double width, double depth) {
    return fmt::format("{:.6g} x {:.6g} m", width, depth);
}

SampleGrid window_at(const std::array<double, 2>& position, const Terrain& model,
                     const Terrain& terrain, double cell) {
    return {position[0] * model.heights.width() - 0.5 * cell * terrain.heights.width(),
            (1.0 - position[1]) * model.heights.height() -
                0.5 * cell * terrain.heights.height(),
            cell};
}

// A window as large as the terrain, around the position.
SampleGrid true_to_scale(const Options& options, const Terrain& model,
                         const Terrain& terrain) {
    const SampleGrid window =
        window_at(options.position, model, terrain, terrain.spacing / model.spacing);
    const double east = window.west + window.cell * terrain.heights.width();
    const double south = window.north + window.cell * terrain.heights.height();
    // Up to half a cell outside the model its outermost heights are still the nearest.
    constexpr double kBeyond = 0.5 + 1e-6;
    if (std::min(window.west, window.north) >= -kBeyond &&
        east <= model.heights.width() + kBeyond &&
        south <= model.heights.height() + kBeyond)
        return window;

    const bool could_fit =
        terrain.width() <= model.width() && terrain.depth() <= model.depth();
    const std::string sizes = fmt::format("the terrain is {} and the model {}",
                                          size_text(terrain.width(), terrain.depth()),
                                          size_text(model.width(), model.depth()));
    if (!could_fit)
        throw bad_request(
            "{}: {}: make terrain.extent smaller, or set fit = true to stretch the model",
            options.source.name(), sizes);
    throw bad_request(
        "{}: {}, so the window at position [{:g}, {:g}] leaves it: keep position between "
        "[{:.4g}, {:.4g}] and [{:.4g}, {:.4g}], or set fit = true",
        options.source.name(), sizes, options.position[0], options.position[1],
        0.5 * terrain.width() / model.width(), 0.5 * terrain.depth() / model.depth(),
        1.0 - 0.5 * terrain.width() / model.width(),
        1.0 - 0.5 * terrain.depth() / model.depth());
}

// The largest window, moved as near to the position as the model allows.
SampleGrid largest(const Options& options, const Terrain& model, const Terrain& terrain) {
    const double cell =
        std::min(double(model.heights.width()) / terrain.heights.width(),
                 double(model.heights.height()) / terrain.heights.height());
    SampleGrid window = window_at(options.position, model, terrain, cell);
    const auto within = [](double begin, double length, int cells) {
        return std::clamp(begin, 0.0, std::max(0.0, cells - length));
    };
    window.west =
        within(window.west, cell * terrain.heights.width(), model.heights.width());
    window.north =
        within(window.north, cell * terrain.heights.height(), model.heights.height());
    return window;
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    context.progress->step("dem: reading the model");
    std::string what_was_done;
    const Terrain model = read_dem(options.source, &what_was_done);
    if (!what_was_done.empty())
        context.progress->note(
            fmt::format("{}: {}", options.source.name(), what_was_done));

    const SampleGrid window = options.fit ? largest(options, model, terrain)
                                          : true_to_scale(options, model, terrain);
    if (options.fit)
        context.progress->note(
            fmt::format("{}: {} of the model stand for {}", options.source.name(),
                        size_text(window.cell * model.spacing * terrain.heights.width(),
                                  window.cell * model.spacing * terrain.heights.height()),
                        size_text(terrain.width(), terrain.depth())));

    Terrain result;
    result.spacing = terrain.spacing;
    result.heights =
        sampled(model.heights, window, terrain.heights.width(), terrain.heights.height());
    if (options.vertical_scale != 1.0)
        for (float& height : result.heights)
            height = static_cast<float>(height * options.vertical_scale);
    return result;
}

}  // namespace cydonia::dem
