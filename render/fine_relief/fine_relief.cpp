#include "render/fine_relief/fine_relief.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "field/image.h"
#include "field/parallel.h"
#include "field/random.h"
#include "field/sampled.h"
#include "field/smoothstep.h"
#include "render/fine_relief/crags.h"
#include "render/fine_relief/craters.h"
#include "render/fine_relief/gullies.h"
#include "render/ground/texture_noise.h"

namespace cydonia::render {
namespace {

// Amplitudes, over the wavelength.
constexpr double kGullies = 0.06, kCrags = 0.045;
constexpr int kMostFactor = 8;
constexpr double kLeastCells = 4.0;  // the shortest wavelength, in samples
// The mean square rise between samples k and 2k apart grows by 2^(2H); of real mountains
// H is 0.6 to 0.85 (Mark and Aronson 1984), of smooth ones 1.
constexpr double kSmoothest = 0.85;

int longest_side(Quality quality) {
    switch (quality) {
        case Quality::kDraft:
            return 1024;
        case Quality::kPreview:
            return 2048;
        case Quality::kFinal:
            break;
    }
    return 4096;
}

double mean_square_rise(const Field<float>& h, int apart) {
    double sum = 0.0;
    std::size_t count = 0;
    for (int y = 0; y + apart < h.height(); ++y)
        for (int x = 0; x + apart < h.width(); ++x) {
            const double e = h(x + apart, y) - h(x, y), s = h(x, y + apart) - h(x, y);
            sum += e * e + s * s;
            count += 2;
        }
    return count ? sum / static_cast<double>(count) : 0.0;
}

// The wavelength, in samples, below which the land has less form than real land.
double first_missing(const Field<float>& heights) {
    double cells = kLeastCells;
    double here = mean_square_rise(heights, 1);
    for (int apart = 1; apart <= 4; apart *= 2) {
        const double twice = mean_square_rise(heights, 2 * apart);
        if (here <= 0.0 || 0.5 * std::log2(twice / here) < kSmoothest) break;
        cells *= 2.0;
        here = twice;
    }
    return cells;
}

Field<float> doubled(const Field<float>& field) {
    return sampled(field, {.cell = 0.5}, 2 * field.width(), 2 * field.height());
}

template <class T>
Field<T> repeated(const Field<T>& field, int factor) {
    Field<T> result(factor * field.width(), factor * field.height());
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x)
            result(x, y) = field(x / factor, y / factor);
    return result;
}

// Terraces: hard beds are walls and soft beds are benches. The lower part of a bed rises
// little and the upper part much.
void cut_terraces(Field<float>& heights, const Field<float>& dry, double spacing,
                  double strength, double step, std::uint64_t seed) {
    const auto bed = [](double at) {
        const double floor = std::floor(at), f = at - floor;
        return floor + 0.25 * f + 0.75 * smoothstep(0.35, 0.85, f);
    };
    parallel_for(heights.height(), 8, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            const double wave =
                0.25 * texture_noise((x + 0.5) * spacing, (y + 0.5) * spacing,
                                     12.0 * step, seed);
            double at = heights(x, y) / step + wave;
            at += strength * 0.75 * (bed(at) - at);
            const double fine = 2.9 * at;
            at += strength * 0.6 * (bed(fine) - fine) / 2.9;
            const float cut = static_cast<float>((at - wave) * step);
            heights(x, y) += dry(x, y) * (cut - heights(x, y));
        }
    });
}

// The octaves of one level, from the wavelength `longest` (metres) down, on the land of
// the levels before it.
class Level {
  public:
    Level(const FineReliefOptions& options, const Field<float>& dry, double spacing,
          std::uint64_t seed)
        : options_(options), dry_(dry), spacing_(spacing), seed_(seed) {}

    void add_octave(Field<float>& heights, double wavelength) const {
        const std::uint64_t seed =
            hash_of({seed_, std::bit_cast<std::uint64_t>(wavelength)});
        const auto add = [&](const Field<float>& form, double metres) {
            for (std::size_t i = 0; i < heights.size(); ++i)
                heights[i] += static_cast<float>(metres) * dry_[i] * form[i];
        };
        if (options_.gullies > 0.0)
            add(gullies(heights, spacing_, wavelength, seed),
                kGullies * options_.gullies * wavelength);
        if (options_.crags > 0.0)
            add(crags(heights, spacing_, wavelength, seed),
                kCrags * options_.crags * wavelength);
        if (options_.craters > 0.0)
            add(craters(heights.width(), heights.height(), spacing_, wavelength, seed),
                options_.craters);
    }

  private:
    const FineReliefOptions& options_;
    const Field<float>& dry_;  // 1 on land, 0 under water and beside it
    double spacing_;
    std::uint64_t seed_;
};

// 0 under water, 1 from three samples away from it.
Field<float> dry_share(const Terrain& terrain) {
    Field<float> dry(terrain.heights.width(), terrain.heights.height(), 1.0f);
    if (terrain.water.empty()) return dry;
    for (int y = 0; y < dry.height(); ++y)
        for (int x = 0; x < dry.width(); ++x) {
            double nearest = 9.0;
            for (int dy = -3; dy <= 3; ++dy)
                for (int dx = -3; dx <= 3; ++dx)
                    if (dry.contains(x + dx, y + dy) &&
                        water_depth(terrain, dry.index(x + dx, y + dy)) > 0.0f)
                        nearest = std::min(nearest, std::hypot(dx, dy));
            dry(x, y) = static_cast<float>(std::clamp((nearest - 1.0) / 2.0, 0.0, 1.0));
        }
    return dry;
}

// The level of water over the finer bed: that of the sample, or that of its wet
// neighbours where the bed between them lies below it.
Field<float> finer_water(const Terrain& coarse, const Field<float>& heights, int factor) {
    if (coarse.water.empty()) return {};
    Field<float> water(heights.width(), heights.height(), kDry);
    parallel_for(heights.height(), 16, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            const int i = x / factor, j = y / factor;
            float level = coarse.water(i, j);
            if (level == kDry || level <= coarse.heights(i, j))
                for (int b = std::max(0, j - 1);
                     b <= std::min(coarse.water.height() - 1, j + 1); ++b)
                    for (int a = std::max(0, i - 1);
                         a <= std::min(coarse.water.width() - 1, i + 1); ++a)
                        if (coarse.water(a, b) > coarse.heights(a, b) &&
                            coarse.water(a, b) > heights(x, y))
                            level = std::max(level, coarse.water(a, b));
            water(x, y) = level;
        }
    });
    return water;
}

}  // namespace

int fine_factor(const FineReliefOptions& options, int samples, Quality quality) {
    if (options.factor) return *options.factor;
    int factor = 1;
    while (factor < kMostFactor && 2 * factor * samples <= longest_side(quality))
        factor *= 2;
    return factor;
}

Terrain with_fine_relief(const Terrain& terrain, const FineReliefOptions& options,
                         int factor, std::uint64_t seed) {
    if (factor == 1) return terrain;
    Terrain fine;
    fine.figures = terrain.figures;
    fine.pictures = terrain.pictures;
    fine.heights = terrain.heights;
    fine.spacing = terrain.spacing;
    Field<float> dry = dry_share(terrain);
    double wavelength = first_missing(terrain.heights) * terrain.spacing;
    for (int done = 1;; done *= 2) {
        const bool last = done == factor;
        // An octave is drawn at the first level with enough samples for it.
        const double enough = (last ? kLeastCells : 2.0 * kLeastCells) * fine.spacing;
        const Level level(options, dry, fine.spacing,
                          hash_of({seed, key("fine relief")}));
        for (; wavelength >= enough; wavelength /= 2.0)
            level.add_octave(fine.heights, wavelength);
        if (last) break;
        fine.heights = doubled(fine.heights);
        fine.spacing /= 2.0;
        dry = doubled(dry);
        for (float& share : dry) share = std::clamp(share, 0.0f, 1.0f);
        if (done == 1 && options.terraces > 0.0)
            cut_terraces(fine.heights, dry, fine.spacing, options.terraces, options.step,
                         hash_of({seed, key("terraces")}));
    }
    for (const auto& [name, mask] : terrain.masks)
        fine.masks.emplace(name,
                           resized(mask, fine.heights.width(), fine.heights.height()));
    fine.water = finer_water(terrain, fine.heights, factor);
    for (const ShadowImage& image : terrain.shadows) {
        ShadowImage finer = image;
        finer.target = repeated(image.target, factor);
        if (!image.window.empty()) finer.window = repeated(image.window, factor);
        if (!image.relaxed.empty()) finer.relaxed = repeated(image.relaxed, factor);
        fine.shadows.push_back(std::move(finer));
    }
    return fine;
}

}  // namespace cydonia::render
