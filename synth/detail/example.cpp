#include "synth/detail/example.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "field/dem.h"
#include "field/error.h"
#include "field/parallel.h"
#include "field/sampled.h"

namespace cydonia::detail {
namespace {

constexpr double kMostCells = 1 << 28;  // of a resampled target
// A target that is coarser than a level by at most this factor still belongs to it.
constexpr double kNearEnough = 1.25;

struct Model {
    Field<float> heights;
    Field<std::uint8_t> voids;
    double spacing;  // metres
};

Model model_of(const Target& target, Progress& progress) {
    const Source& source = target.source;
    Model model;
    std::string what_was_done;
    Terrain terrain = read_dem(source, &what_was_done, &model.voids);
    if (!what_was_done.empty())
        progress.note(fmt::format("{}: {}", source.name(), what_was_done));
    model.heights = std::move(terrain.heights);
    model.spacing = target.scale * terrain.spacing;
    return model;
}

// The target resampled to cells of another size, as many as fit.
Model resampled(const Model& model, double spacing, const std::string& name) {
    const double cell = spacing / model.spacing;
    const double across = std::floor(model.heights.width() / cell + 1e-6),
                 down = std::floor(model.heights.height() / cell + 1e-6);
    if (!(across * down <= kMostCells))
        throw bad_request(
            "{}: {:.0f} x {:.0f} cells at the land's {:.4g} m are too many; give a part "
            "of it, or a land of larger cells",
            name, across, down, spacing);
    const int width = std::max(1, int(across)), height = std::max(1, int(down));
    Model result{sampled(model.heights, {0.0, 0.0, cell}, width, height), {}, spacing};
    if (model.voids.empty()) return result;
    Field<float> share(model.voids.width(), model.voids.height());
    std::ranges::copy(model.voids, share.begin());
    share = sampled(share, {0.0, 0.0, cell}, width, height);
    result.voids = Field<std::uint8_t>(width, height);
    std::ranges::transform(share, result.voids.begin(),
                           [](float weight) { return std::abs(weight) > 0.02f; });
    return result;
}

// The finest of the land's levels for which a target has details.
int first_level(double target_spacing, double spacing, int levels,
                const std::string& name) {
    int first = 0;
    while (target_spacing > kNearEnough * std::ldexp(spacing, first)) ++first;
    if (first >= levels)
        throw bad_request(
            "{}: its cells of {:.4g} m are too coarse for a land of {:.4g} m and {} "
            "levels of detail, the coarsest of which is {:.4g} m: give a finer model, "
            "more levels, or a land of larger cells",
            name, target_spacing, spacing, levels, std::ldexp(spacing, levels - 1));
    return first;
}

// The longest line of at most `length` values that can be halved so many times.
int cut_to(Filter filter, int length, int levels) {
    while (length > 0 && divisible(filter, length, levels) != length) --length;
    return length;
}

}  // namespace

Example example_of(const Field<float>& heights, const Field<std::uint8_t>& voids,
                   Filter filter, int levels) {
    const int w = cut_to(filter, heights.width(), levels),
              h = cut_to(filter, heights.height(), levels);
    if (w <= 0 || h <= 0) return {};
    Field<float> land(w, h);
    for (int y = 0; y < h; ++y)
        std::copy_n(heights.row(y).begin(), w, land.row(y).begin());
    Example example{0, 0, decomposed(std::move(land), filter, levels), {}};
    for (int level = 0; level < levels && !voids.empty(); ++level) {
        const Field<float>& coarse = example.levels[std::size_t(level)].coarse;
        Field<std::uint8_t> unknown(coarse.width(), coarse.height());
        const int cell = 2 << level;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                if (voids(x, y))
                    unknown(std::min(x / cell, coarse.width() - 1),
                            std::min(y / cell, coarse.height() - 1)) = 1;
        example.unknown.push_back(std::move(unknown));
    }
    return example;
}

std::vector<Example> examples_of(const Options& options, double spacing,
                                 Progress& progress) {
    std::vector<Example> examples;
    for (std::size_t i = 0; i < options.targets.size(); ++i) {
        const Source& source = options.targets[i].source;
        Model model = model_of(options.targets[i], progress);
        const int first =
            first_level(model.spacing, spacing, options.levels, source.name());
        const double wanted = std::ldexp(spacing, first);
        if (first > 0)
            progress.warn(
                fmt::format("{}: its cells are {:.4g} m, so the finest {} of detail of a "
                            "land of {:.4g} m {} without",
                            source.name(), model.spacing,
                            first == 1 ? "level" : fmt::format("{} levels", first),
                            spacing, first == 1 ? "goes" : "go"));
        if (std::abs(model.spacing / wanted - 1.0) > 1e-3) {
            progress.note(
                fmt::format("{}: its cells of {:.4g} m were resampled to {:.4g} m",
                            source.name(), model.spacing, wanted));
            model = resampled(model, wanted, source.name());
        }
        for (int o = 0; o < options.orientations; ++o) {
            Example example =
                example_of(oriented(model.heights, o), oriented(model.voids, o),
                           options.filter, options.levels - first);
            if (example.levels.empty())
                throw bad_request(
                    "{}: {} x {} cells of {:.4g} m are too few for {} levels of detail; "
                    "give a larger model or fewer levels",
                    source.name(), model.heights.width(), model.heights.height(), wanted,
                    options.levels - first);
            example.target = static_cast<int>(i);
            example.first = first;
            examples.push_back(std::move(example));
        }
    }
    return examples;
}

}  // namespace cydonia::detail
