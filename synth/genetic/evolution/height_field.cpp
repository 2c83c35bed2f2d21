#include "synth/genetic/evolution/height_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "field/random.h"
#include "synth/genetic/evolution/base.h"

namespace cydonia::genetic {
namespace {

constexpr int kLeastSide = 4, kLeastCells = 6;

Field<std::uint8_t> types_of(const Regions& regions) {
    Field<std::uint8_t> types(regions.at.width(), regions.at.height());
    std::ranges::transform(regions.at, types.begin(), [&](int region) {
        return std::uint8_t(regions.types[std::size_t(region)]);
    });
    return types;
}

// The widest gene, at most the requested one, for which every type has enough positions
// to choose from.
int side_of(const LevelSamples& samples, const Regions& regions, int asked) {
    int side = asked;
    for (const int type : regions.types) {
        int widest = 0;
        for (const int index : samples.of_type[std::size_t(type)]) {
            const Sample& s = samples.all[std::size_t(index)];
            widest = std::max(widest, std::min(s.width(), s.height()));
        }
        side = std::min(side, 2 * widest / 3);
    }
    return std::max(side, kLeastSide);
}

// Removes samples that are too small for a gene.
LevelSamples fitting(LevelSamples samples, int side) {
    for (auto& own : samples.of_type)
        std::erase_if(own, [&](int index) {
            const Sample& s = samples.all[std::size_t(index)];
            return std::min(s.width(), s.height()) < side;
        });
    return samples;
}

// What a level was made with, for the next one.
struct Before {
    std::unique_ptr<GeneGrid> grid;
    std::unique_ptr<LevelSamples> samples;
    std::unique_ptr<Chromosome> genes;  // null where texture made the level
};

// For each slot the gene that continues the coarser level's land there (coherence across
// levels, a wish of section VII.9).
std::vector<std::optional<Gene>> inherited_genes(const GeneGrid& grid,
                                                 const LevelSamples& samples,
                                                 const Before& before, int ratio) {
    std::vector<std::optional<Gene>> inherited(grid.slots.size());
    std::map<int, int> index_of;
    for (std::size_t i = 0; i < samples.all.size(); ++i)
        index_of[samples.all[i].example] = int(i);
    for (std::size_t slot = 0; slot < grid.slots.size(); ++slot) {
        const auto& s = grid.slots[slot];
        const int x0 = s.column * grid.step(), y0 = s.row * grid.step();
        const int x = std::min((x0 + grid.side / 2) / ratio, before.grid->width - 1),
                  y = std::min((y0 + grid.side / 2) / ratio, before.grid->height - 1);
        const auto layer =
            std::ranges::find(before.grid->types, grid.types[std::size_t(s.layer)]);
        if (layer == before.grid->types.end()) continue;
        const int owner =
            before.genes->owner(int(layer - before.grid->types.begin()), x, y);
        if (owner < 0) continue;
        const auto& from = before.grid->slots[std::size_t(owner)];
        Gene gene = continued(before.genes->gene(owner), before.grid->side, ratio,
                              x0 - ratio * from.column * before.grid->step(),
                              y0 - ratio * from.row * before.grid->step(), grid.side);
        const auto found =
            index_of.find(before.samples->all[std::size_t(gene.sample)].example);
        if (found == index_of.end()) continue;
        gene.sample = found->second;
        const Sample& sample = samples.all[std::size_t(gene.sample)];
        // A model that is read smaller has other land here than on the level before.
        if (sample.smaller || std::min(sample.width(), sample.height()) < grid.side)
            continue;
        gene = kept_inside(gene, grid.side, sample);
        if (sample.land->any_void(gene.x, gene.y, grid.side, grid.side)) continue;
        inherited[slot] = gene;
    }
    return inherited;
}

// Makes the means of the finer land equal to the coarser level's land (section IV.3.3.6).
void conform(Field<float>& heights, const Field<float>& coarse, int times) {
    Field<float> off = coarser(heights, times);
    for (std::size_t i = 0; i < off.size(); ++i) off[i] = coarse[i] - off[i];
    const Field<float> correction = finer(off, times, heights.width(), heights.height());
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += correction[i];
}

double seam_energy_of(const Field<float>& h, const GeneGrid& grid, const Chromosome& c,
                      const Field<std::uint8_t>& types) {
    // Compares the bends to the east and south of each cell where there is a seam and
    // where there is none; for each type separately, as some bend more than others.
    double weighted = 0.0, seams = 0.0;
    for (std::size_t layer = 0; layer < grid.types.size(); ++layer) {
        double at = 0.0, inside = 0.0;
        std::size_t n_at = 0, n_inside = 0;
        for (int y = 1; y + 2 < h.height(); ++y)
            for (int x = 1; x + 2 < h.width(); ++x) {
                if (types(x, y) != grid.types[layer]) continue;
                const int own = c.owner(int(layer), x, y);
                for (const bool south : {false, true}) {
                    const int dx = !south, dy = south;
                    if (types(x + dx, y + dy) != types(x, y)) continue;
                    const int next = c.owner(int(layer), x + dx, y + dy);
                    const double bend =
                        0.5 *
                        (std::abs(h(x - dx, y - dy) - 2.0 * h(x, y) + h(x + dx, y + dy)) +
                         std::abs(h(x, y) - 2.0 * h(x + dx, y + dy) +
                                  h(x + 2 * dx, y + 2 * dy)));
                    if (own == next) {
                        inside += bend, ++n_inside;
                        continue;
                    }
                    const auto& a = grid.slots[std::size_t(own)];
                    const auto& b = grid.slots[std::size_t(next)];
                    const Gene on = continued(c.gene(own), grid.side, 1,
                                              (b.column - a.column) * grid.step(),
                                              (b.row - a.row) * grid.step(), grid.side);
                    if (on == c.gene(next)) continue;
                    at += bend, ++n_at;
                }
            }
        if (n_at == 0 || !(inside > 0.0)) continue;
        weighted += double(n_at) * (at / double(n_at)) / (inside / double(n_inside));
        seams += double(n_at);
    }
    return seams > 0.0 ? weighted / seams : 0.0;
}

// Makes the levels of a height field one after another, coarse to fine.
class LevelBuilder {
  public:
    // The arguments must outlive it.
    LevelBuilder(int ratio, const EvolutionOptions& options,
                 const PlacedFeatures& features, std::uint64_t seed, Progress& progress)
        : ratio_(ratio),
          options_(options),
          features_(features),
          seed_(seed),
          progress_(progress) {}

    // Makes a level by the genetic algorithm: the base level around the heights of its
    // regions, any other as detail on the level before.
    void evolve(std::size_t level, const LevelSamples& samples, const Regions& regions) {
        const bool is_base = done_.empty();
        const int side = side_of(samples, regions, options_.gene);
        std::optional<Base> base;
        if (is_base) base = base_of(samples, regions);
        auto own = std::make_unique<LevelSamples>(
            fitting(is_base ? base->samples : samples, side));
        const Field<std::uint8_t> types = types_of(regions);
        auto grid = std::make_unique<GeneGrid>(grid_of(types, side, overlap_of(side)));
        const Field<float> pattern =
            is_base ? base->pattern
                    : finer(done_.back().heights, ratio_, types.width(), types.height());
        const Fitness fitness(
            *grid, *own, pattern, regions,
            is_base ? Fitness::Follows::kElevation : Fitness::Follows::kShape,
            options_.alpha);
        Evolved result = evolved(fitness, inherited_by(*grid, *own), options_,
                                 seed_of(level), progress_);

        LevelDone now;
        now.spacing = samples.spacing, now.side = side;
        now.genes = int(grid->slots.size());
        now.generations = std::move(result.generations);
        now.heights = Field<float>(types.width(), types.height());
        result.best.detail(0, 0, types.width(), types.height(), now.heights.data());
        if (is_base)
            lay_base(now.heights, *base);
        else
            lay_detail(now.heights, pattern);
        now.seam_energy = seam_energy_of(now.heights, *grid, result.best, types);
        finish(std::move(now));
        before_ = {std::move(grid), std::move(own),
                   std::make_unique<Chromosome>(std::move(result.best))};
    }

    // Makes a level by texture, directly from the last one that was made by genes.
    void refine(std::size_t level, double spacing, const Regions& regions,
                const ByTexture& texture) {
        LevelDone now;
        now.spacing = spacing, now.by_texture = true;
        now.heights = texture.refined({before_.grid.get(), before_.samples.get(),
                                       before_.genes.get(), &done_.back().heights},
                                      types_of(regions), seed_of(level), progress_);
        conform(now.heights, done_.back().heights,
                int(std::lround(done_.back().spacing / spacing)));
        finish(std::move(now));
        before_.genes.reset();
    }

    std::vector<LevelDone> taken() { return std::move(done_); }

  private:
    int overlap_of(int side) const {
        return std::clamp(int(std::lround(options_.overlap * side)), 2, side / 2);
    }
    std::uint64_t seed_of(std::size_t level) const {
        return hash_of({seed_, key("level"), level});
    }
    std::vector<std::optional<Gene>> inherited_by(const GeneGrid& grid,
                                                  const LevelSamples& samples) const {
        if (!before_.genes) return std::vector<std::optional<Gene>>(grid.slots.size());
        return inherited_genes(grid, samples, before_, ratio_);
    }
    // Adds the chunks, which are relative to their type's mean, to the regions' heights.
    static void lay_base(Field<float>& heights, const Base& base) {
        for (std::size_t i = 0; i < heights.size(); ++i)
            heights[i] = base.pattern[i] + base.own[i] * heights[i];
    }
    void lay_detail(Field<float>& heights, const Field<float>& pattern) const {
        for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += pattern[i];
        conform(heights, done_.back().heights, ratio_);
    }
    void finish(LevelDone now) {
        if (features_) features_(now.heights, now.spacing);
        done_.push_back(std::move(now));
    }

    int ratio_;
    const EvolutionOptions& options_;
    const PlacedFeatures& features_;
    std::uint64_t seed_;
    Progress& progress_;
    std::vector<LevelDone> done_;
    Before before_;
};

}  // namespace

Regions coarser(const Regions& regions, int ratio) {
    Regions result;
    result.types = regions.types;
    result.cells.resize(regions.types.size());
    result.at = Field<int>((regions.at.width() + ratio - 1) / ratio,
                           (regions.at.height() + ratio - 1) / ratio);
    std::map<int, int> counts;
    for (int y = 0; y < result.at.height(); ++y)
        for (int x = 0; x < result.at.width(); ++x) {
            counts.clear();
            for (int j = y * ratio; j < std::min((y + 1) * ratio, regions.at.height());
                 ++j)
                for (int i = x * ratio; i < std::min((x + 1) * ratio, regions.at.width());
                     ++i)
                    ++counts[regions.at(i, j)];
            const auto most = std::ranges::max_element(
                counts, {}, [](const auto& entry) { return entry.second; });
            result.at(x, y) = most->first;
            ++result.cells[std::size_t(most->first)];
        }
    return result;
}

int base_level(const std::vector<LevelSamples>& samples, const Regions& regions,
               int width, int height, int ratio, double coarsest) {
    const int last = int(samples.size()) - 1;
    int base = last;
    for (int level = last; level >= 0; --level) {
        if (level < last) {
            width = (width + ratio - 1) / ratio, height = (height + ratio - 1) / ratio;
        }
        const LevelSamples& at = samples[std::size_t(level)];
        const bool every = std::ranges::all_of(regions.types, [&](int type) {
            return std::ranges::any_of(at.of_type[std::size_t(type)], [&](int index) {
                const Sample& s = at.all[std::size_t(index)];
                return std::min(s.width(), s.height()) >= kLeastCells;
            });
        });
        if (level < last && (!every || std::min(width, height) < kLeastCells ||
                             at.spacing > 1.001 * coarsest))
            break;
        base = level;
    }
    return base;
}

std::vector<LevelDone> height_field(const Regions& regions,
                                    const std::vector<LevelSamples>& samples, int ratio,
                                    const EvolutionOptions& options,
                                    const PlacedFeatures& features,
                                    const ByTexture* texture, double texture_from,
                                    double texture_to, std::uint64_t seed,
                                    Progress& progress) {
    std::vector<Regions> at_level(samples.size());
    at_level.back() = regions;
    for (std::size_t level = samples.size() - 1; level-- > 0;)
        at_level[level] = coarser(at_level[level + 1], ratio);

    LevelBuilder builder(ratio, options, features, seed, progress);
    for (std::size_t level = 0; level < samples.size(); ++level) {
        const double spacing = samples[level].spacing;
        progress.step(fmt::format("genetic: {:.4g} m", spacing));
        const bool by_texture =
            texture && spacing < 0.99 * texture_from && spacing > 0.99 * texture_to;
        if (!by_texture)
            builder.evolve(level, samples[level], at_level[level]);
        else if (spacing <= 1.01 * texture_to)  // the levels before come with this one
            builder.refine(level, spacing, at_level[level], *texture);
    }
    return builder.taken();
}

}  // namespace cydonia::genetic
