#include "synth/genetic/evolution/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/parallel.h"
#include "field/part.h"
#include "field/sampled.h"

namespace cydonia::genetic {
namespace {

using texture::Model;

constexpr int kShortest =
    4;  // cells: shortest side of a sample from which genes are taken
constexpr std::uint64_t kMostCells = 1u << 27;
// Models that are coarser than a level by less than this factor are resampled; others are
// read smaller.
constexpr double kNearlyAsFine = 1.34;
constexpr double kLeastFall = 0.2,
                 kMostFall = 0.5;  // of roughness, from one level to the next

Field<double> summed(const Field<float>& heights) {
    Field<double> sums(heights.width() + 1, heights.height() + 1);
    for (int y = 0; y < heights.height(); ++y) {
        double row = 0.0;
        for (int x = 0; x < heights.width(); ++x) {
            row += heights(x, y);
            sums(x + 1, y + 1) = sums(x + 1, y) + row;
        }
    }
    return sums;
}

Field<std::int32_t> summed(const Field<std::uint8_t>& voids) {
    Field<std::int32_t> sums(voids.width() + 1, voids.height() + 1);
    for (int y = 0; y < voids.height(); ++y) {
        std::int32_t row = 0;
        for (int x = 0; x < voids.width(); ++x) {
            row += voids(x, y);
            sums(x + 1, y + 1) = sums(x + 1, y) + row;
        }
    }
    return sums;
}

template <class T>
T over(const Field<T>& sums, int x, int y, int width, int height) {
    return sums(x + width, y + height) - sums(x, y + height) - sums(x + width, y) +
           sums(x, y);
}

Model model_of(const Example& example, Progress& progress) {
    Model model = texture::model_of(exemplar_of(example), progress);
    const Field<float>& heights = model.terrain.heights;
    const std::string name = example.source.name();
    if (std::min(heights.width(), heights.height()) < kShortest)
        throw bad_request(
            "{}: its window holds {} x {} cells of {:.4g} m; at least {} x {} are needed",
            name, heights.width(), heights.height(), model.terrain.spacing, kShortest,
            kShortest);
    const auto [low, high] = std::ranges::minmax(heights);
    if (!(double(high) - low < 1e6))
        throw bad_request(
            "{}: its heights go from {:g} to {:g} m, which no land does: check its unit",
            name, low, high);
    return model;
}

void refuse_large(const std::string& name, const Model& model, double spacing) {
    const double cell = spacing / model.terrain.spacing;
    const double w = model.terrain.heights.width() / cell,
                 h = model.terrain.heights.height() / cell;
    if (!(std::max(w, h) <= 16384.0))
        throw bad_request(
            "{}: {:.0f} x {:.0f} cells of {:.4g} m are too many: give a window of it",
            name, w, h, spacing);
}

double rms(const Field<float>& field) {
    double sum = 0.0;
    for (const float v : field) sum += double(v) * v;
    return field.empty() ? 0.0 : std::sqrt(sum / double(field.size()));
}

Field<std::uint8_t> coarser_voids(const Field<std::uint8_t>& fine, int ratio) {
    Field<std::uint8_t> result((fine.width() + ratio - 1) / ratio,
                               (fine.height() + ratio - 1) / ratio);
    for (int y = 0; y < fine.height(); ++y)
        for (int x = 0; x < fine.width(); ++x) result(x / ratio, y / ratio) |= fine(x, y);
    return result;
}

// One example on all levels, the coarsest first; null at levels where it has too few
// cells.
std::vector<Sample> levels_of(const std::string& name, Model model, int type, int example,
                              double spacing, int ratio, int levels) {
    std::vector<Sample> result(static_cast<std::size_t>(levels),
                               Sample{.type = type, .example = example, .land = {}});
    int finest = levels - 1;
    double own = spacing;
    while (finest > 0 && model.terrain.spacing > own * kNearlyAsFine)
        own *= ratio, --finest;
    refuse_large(name, model, own);
    if (std::abs(model.terrain.spacing / own - 1.0) > 1e-3)
        model = texture::resampled(model, own);
    const Field<float>& all = model.terrain.heights;

    // The cells of all levels are nested, so that land keeps its position from level to
    // level.
    int step = 1;
    for (int level = finest;
         level > 0 && std::min(all.width(), all.height()) >= step * ratio * kShortest;
         --level)
        step *= ratio;
    const int w = all.width() / step * step, h = all.height() / step * step;
    if (w == 0 || h == 0) return result;
    const int x = (all.width() - w) / 2, y = (all.height() - h) / 2;
    for (Sample& sample : result) sample.west = x * own, sample.north = y * own;
    Field<float> heights = part(all, x, y, w, h);
    Field<std::uint8_t> voids =
        model.voids.empty() ? Field<std::uint8_t>() : part(model.voids, x, y, w, h);
    for (int level = finest; level >= 0; --level) {
        if (std::min(heights.width(), heights.height()) < kShortest) break;
        auto land = std::make_shared<SampleLand>();
        Field<float> coarse = coarser(heights, ratio);
        if (level > 0) {
            land->detail = finer(coarse, ratio, heights.width(), heights.height());
            for (std::size_t i = 0; i < heights.size(); ++i)
                land->detail[i] = heights[i] - land->detail[i];
        }
        land->sums = summed(heights);
        if (std::ranges::any_of(voids, [](std::uint8_t v) { return v != 0; }))
            land->voids = summed(voids);
        land->heights = std::move(heights);
        result[std::size_t(level)].land = std::move(land);
        heights = std::move(coarse);
        voids = coarser_voids(voids, ratio);
    }
    const auto at = [&](int level) -> Sample& { return result[std::size_t(level)]; };
    if (!at(finest).land || finest + 1 >= levels) return result;
    const double fine = rms(at(finest).land->detail),
                 before = finest > 1 && at(finest - 1).land
                              ? rms(at(finest - 1).land->detail)
                              : 0.0;
    const double fall =
        std::clamp(before > 0.0 ? fine / before : 1.0 / ratio, kLeastFall, kMostFall);
    for (int level = finest + 1; level < levels; ++level) {
        at(level).land = at(finest).land;
        at(level).gain = float(at(level - 1).gain * fall);
        at(level).smaller = true;
    }
    return result;
}

}  // namespace

texture::Exemplar exemplar_of(const Example& example) {
    texture::Exemplar exemplar{.source = example.source, .types = {}, .type = {}};
    exemplar.window = example.window;
    exemplar.scale = example.scale, exemplar.vertical_scale = example.vertical_scale;
    exemplar.raise = example.raise;
    return exemplar;
}

double SampleLand::mean(int x, int y, int width, int height) const {
    return over(sums, x, y, width, height) / (double(width) * height);
}

bool SampleLand::any_void(int x, int y, int width, int height) const {
    return !voids.empty() && over(voids, x, y, width, height) > 0;
}

Field<float> coarser(const Field<float>& fine, int ratio) {
    Field<float> result((fine.width() + ratio - 1) / ratio,
                        (fine.height() + ratio - 1) / ratio);
    parallel_for(result.height(), 16, [&](int y) {
        for (int x = 0; x < result.width(); ++x) {
            const int x1 = std::min((x + 1) * ratio, fine.width()),
                      y1 = std::min((y + 1) * ratio, fine.height());
            double sum = 0.0;
            for (int j = y * ratio; j < y1; ++j)
                for (int i = x * ratio; i < x1; ++i) sum += fine(i, j);
            result(x, y) = float(sum / ((x1 - x * ratio) * (y1 - y * ratio)));
        }
    });
    return result;
}

Field<float> finer(const Field<float>& coarse, int ratio, int width, int height) {
    return sampled(coarse, {0.0, 0.0, 1.0 / ratio}, width, height);
}

std::vector<LevelSamples> samples_of(const LibraryOptions& library,
                                     std::span<const std::uint8_t> used, double spacing,
                                     int ratio, int levels, Progress& progress) {
    std::vector<LevelSamples> result(static_cast<std::size_t>(levels));
    for (int level = levels - 1; level >= 0; --level) {
        LevelSamples& of = result[std::size_t(level)];
        of.spacing = spacing * std::pow(double(ratio), levels - 1 - level);
        of.of_type.resize(library.types.size());
    }
    std::uint64_t cells = 0;
    int number = 0;
    for (std::size_t t = 0; t < library.types.size(); ++t) {
        if (!used[t]) continue;
        const TypeOptions& type = library.types[t];
        if (type.examples.empty())
            throw bad_request(
                "the type '{}' of {} has no samples to make land of: give it an example",
                type.name, library.name);
        for (const Example& example : type.examples) {
            Model model = model_of(example, progress);
            cells += model.terrain.heights.size();
            if (cells > kMostCells)
                throw bad_request(
                    "the samples up to {} have {} cells, more than {}: give windows of "
                    "them",
                    example.source.name(), cells, kMostCells);
            std::vector<Sample> all = levels_of(example.source.name(), std::move(model),
                                                int(t), number++, spacing, ratio, levels);
            for (std::size_t level = 0; level < all.size(); ++level)
                if (all[level].land) {
                    result[level].of_type[t].push_back(int(result[level].all.size()));
                    result[level].all.push_back(std::move(all[level]));
                }
        }
    }
    return result;
}

}  // namespace cydonia::genetic
