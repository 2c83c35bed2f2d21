#include "synth/texture/database/exemplars.h"

#include <algorithm>
#include <cmath>

#include "field/dem.h"
#include "field/error.h"
#include "field/part.h"
#include "field/sampled.h"
#include "synth/texture/database/types.h"

namespace cydonia::texture {
namespace {

constexpr std::uint64_t kMostCells = std::uint64_t{1} << 28;  // of all exemplars

void refuse_size(const std::string& name, double width, double height, double spacing) {
    const std::string size =
        fmt::format("{:.0f} x {:.0f} cells of {:.4g} m", width, height, spacing);
    if (!(std::max(width, height) <= kLongestSide))
        throw bad_request(
            "{}: {}, more than {} x {}: give a larger spacing or a smaller exemplar",
            name, size, kLongestSide, kLongestSide);
    if (!(std::min(width, height) >= kShortestSide))
        throw bad_request(
            "{}: {}: an exemplar needs {} x {} at least; give a larger one or a smaller "
            "spacing",
            name, size, kShortestSide, kShortestSide);
}

void refuse_unusable(const std::string& name, const Model& model) {
    const Field<float>& heights = model.terrain.heights;
    refuse_size(name, heights.width(), heights.height(), model.terrain.spacing);
    const auto [low, high] = std::ranges::minmax(heights);
    if (!(double(high) - low < 1e7))
        throw bad_request(
            "{}: its heights go from {:g} to {:g} m, which no land does: check its unit "
            "and "
            "vertical_scale",
            name, low, high);
    if (!(high - low > 1e-3f))
        throw bad_request(
            "{}: all its heights are {:g} m; a flat exemplar is of no use: remove it",
            name, low + 0.0f);  // no -0
}

Model at_spacing(const std::string& name, Model model, double spacing,
                 Progress& progress) {
    const double own = model.terrain.spacing;
    if (std::abs(own / spacing - 1.0) < 1e-3) return model;
    progress.note(
        fmt::format("{}: resampled from cells of {:.4g} m to the synthesis' {:.4g} m",
                    name, own, spacing));
    const double columns =
        std::floor(model.terrain.heights.width() * own / spacing + 1e-6);
    const double rows = std::floor(model.terrain.heights.height() * own / spacing + 1e-6);
    refuse_size(name, columns, rows, spacing);
    return resampled(model, spacing);
}

// Fills in the types, T^0, of all lands.
void add_types(const Options& options, Lands& lands) {
    if (options.automatic_types && !options.types.empty()) {
        std::vector<Field<float>> heights;
        for (const Land& land : lands.all) heights.push_back(land.heights);
        auto types = automatic_types(heights, lands.spacing,
                                     static_cast<int>(options.types.size()));
        for (std::size_t i = 0; i < types.size(); ++i)
            lands.all[i].types = std::move(types[i]);
    }
    for (std::size_t i = 0; i < lands.all.size(); ++i) {
        Land& land = lands.all[i];
        if (!land.types.same_shape(land.heights))
            land.types = painted_types(options, static_cast<int>(i), land.heights.width(),
                                       land.heights.height());
    }
}

}  // namespace

Model model_of(const Exemplar& exemplar, Progress& progress) {
    Model model;
    std::string what_was_done;
    model.terrain = read_dem(exemplar.source, &what_was_done, &model.voids);
    if (!what_was_done.empty())
        progress.note(fmt::format("{}: {}", exemplar.source.name(), what_was_done));
    const int w = model.terrain.heights.width(), h = model.terrain.heights.height();
    const auto at = [](double share, int n) {
        return std::clamp(int(std::lround(share * n)), 0, n);
    };
    const auto [west, south, east, north] = exemplar.window;
    const int x = at(west, w), y = at(1.0 - north, h), columns = at(east, w) - x,
              rows = at(1.0 - south, h) - y;
    if (columns < 1 || rows < 1)
        throw bad_request("{}: its window holds none of its {} x {} cells",
                          exemplar.source.name(), w, h);
    if (columns < w || rows < h) {
        model.terrain.heights = part(model.terrain.heights, x, y, columns, rows);
        if (!model.voids.empty()) model.voids = part(model.voids, x, y, columns, rows);
    }
    model.terrain.spacing *= exemplar.scale;
    if (exemplar.vertical_scale != 1.0 || exemplar.raise != 0.0)
        for (float& height : model.terrain.heights)
            height =
                static_cast<float>(height * exemplar.vertical_scale + exemplar.raise);
    return model;
}

Model resampled(const Model& model, double spacing) {
    const Field<float>& from = model.terrain.heights;
    const double cell = spacing / model.terrain.spacing;
    const int width = static_cast<int>(std::floor(from.width() / cell + 1e-6)),
              height = static_cast<int>(std::floor(from.height() / cell + 1e-6));
    const SampleGrid grid{0.5 * (from.width() - cell * width),
                          0.5 * (from.height() - cell * height), cell};
    Model result;
    result.terrain.spacing = spacing;
    result.terrain.heights = sampled(from, grid, width, height);
    if (!model.voids.empty()) {
        Field<float> share(from.width(), from.height());
        std::ranges::copy(model.voids, share.begin());
        share = sampled(share, grid, width, height);
        result.voids = Field<std::uint8_t>(width, height);
        std::ranges::transform(share, result.voids.begin(),
                               [](float weight) { return std::abs(weight) > 0.02f; });
    }
    return result;
}

Lands lands_of(const Options& options, Progress& progress) {
    if (options.exemplars.empty())
        throw bad_request("no exemplars: name at least one elevation model");
    if (options.exemplars.size() > kMostExemplars)
        throw bad_request("{} exemplars, more than {}", options.exemplars.size(),
                          kMostExemplars);
    Lands lands;
    lands.spacing = options.spacing;
    std::uint64_t cells = 0;
    for (const Exemplar& exemplar : options.exemplars) {
        progress.report(double(lands.all.size()) / double(options.exemplars.size()));
        const std::string name = exemplar.source.name();
        Model model = model_of(exemplar, progress);
        model.terrain.spacing *= options.scale;
        if (options.vertical_scale != 1.0)
            for (float& height : model.terrain.heights)
                height = static_cast<float>(height * options.vertical_scale);
        if (lands.spacing == 0.0) lands.spacing = model.terrain.spacing;
        model = at_spacing(name, std::move(model), lands.spacing, progress);
        refuse_unusable(name, model);
        cells += model.terrain.heights.size();
        if (cells > kMostCells)
            throw bad_request(
                "the exemplars up to {} have {} cells of {:.4g} m, more than {}: give "
                "fewer, smaller ones or a larger spacing",
                name, cells, lands.spacing, kMostCells);
        lands.all.push_back(
            {name, std::move(model.terrain.heights), std::move(model.voids)});
    }
    add_types(options, lands);
    return lands;
}

}  // namespace cydonia::texture
