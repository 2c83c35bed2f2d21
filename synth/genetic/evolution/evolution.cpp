#include "synth/genetic/evolution/evolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "field/parallel.h"
#include "field/random.h"

namespace cydonia::genetic {
namespace {

constexpr double kMostScale =
    2.0;  // largest factor of a gene's heights; the least is its inverse
constexpr int kDrawn = 24,
              kKept = 3;  // random chunks drawn, and the best of them that are tried
constexpr int kShifts = 6;
constexpr std::array<std::array<int, 2>, 4> kWays = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
// A trial that loses more compatibility than this cannot regain it by similarity.
constexpr double kHopeless = -0.25;

// A sequence of random numbers for one purpose.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double unit() { return cydonia::unit(next()); }
    int below(int n) { return std::min(int(unit() * n), n - 1); }
    double normal() {  // Box and Muller 1958
        const double u = std::max(unit(), 1e-12), v = unit();
        return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
    }

  private:
    std::uint64_t next() { return state_ = mix(state_); }
    std::uint64_t state_;
};

struct Individual {
    Chromosome chromosome;
    std::vector<Compatibility> compatibility;  // of each slot
    std::vector<Fitness::Sums> blocks;
    std::vector<Fitness::Sums> regions;
    std::vector<double> similarity;  // of each region
    double compatible = 0.0;         // sum of compatibility over slots
    double fitness = 0.0;
};

class Breeder {
  public:
    Breeder(const Fitness& fitness, const std::vector<std::optional<Gene>>& inherited,
            const EvolutionOptions& options)
        : fitness_(fitness),
          inherited_(inherited),
          options_(options),
          grid_(fitness.grid()),
          samples_(fitness.samples()) {}

    Individual first(std::uint64_t seed, bool faithful) const;
    void mutate(Individual& individual, std::uint64_t seed) const;
    void cross(Individual& child, const Individual& other, std::uint64_t seed) const;

  private:
    enum class Operator { kScale, kTurn, kShift, kRandom, kGoOn, kInherit, kReset };

    const Sample& sample(const Gene& gene) const {
        return samples_.all[std::size_t(gene.sample)];
    }
    bool is_usable(const Gene& gene) const;
    Gene drawn(int slot, Dice& dice) const;
    std::optional<Gene> gone_on(const Chromosome& c, int slot, int dx, int dy) const;
    Gene best_drawn(int slot, int count, Dice& dice) const;
    std::optional<Gene> mutated(const Individual& i, int slot, Dice& dice) const;
    Gene shifted(const Gene& gene, int slot, Dice& dice) const;
    Gene turned(const Gene& gene, int slot, Dice& dice) const;
    Gene scaled(const Gene& gene, int slot, Dice& dice) const;
    void try_gene(Individual& individual, int slot, const Gene& gene) const;
    void measure(Individual& individual) const;
    void sum_up(Individual& individual) const;

    const Fitness& fitness_;
    const std::vector<std::optional<Gene>>& inherited_;
    const EvolutionOptions& options_;
    const GeneGrid& grid_;
    const LevelSamples& samples_;
};

bool Breeder::is_usable(const Gene& gene) const {
    const Sample& s = sample(gene);
    return gene.x >= 0 && gene.y >= 0 && gene.x + grid_.side <= s.width() &&
           gene.y + grid_.side <= s.height() &&
           !s.land->any_void(gene.x, gene.y, grid_.side, grid_.side);
}

// Random source data (section IV.3.3.5). Every position on the type's samples is equally
// likely.
Gene Breeder::drawn(int slot, Dice& dice) const {
    const int layer = grid_.slots[std::size_t(slot)].layer;
    const auto& own = samples_.of_type[std::size_t(grid_.types[std::size_t(layer)])];
    double places = 0.0;
    const auto places_of = [&](int index) {
        const Sample& s = samples_.all[std::size_t(index)];
        return std::max(0.0, double(s.width() - grid_.side + 1)) *
               std::max(0.0, double(s.height() - grid_.side + 1));
    };
    for (const int index : own) places += places_of(index);
    double at = dice.unit() * places;
    Gene gene{.sample = own.back()};
    for (const int index : own) {
        if (at < places_of(index)) {
            gene.sample = index;
            break;
        }
        at -= places_of(index);
    }
    const Sample& s = sample(gene);
    gene.x = dice.below(std::max(1, s.width() - grid_.side + 1));
    gene.y = dice.below(std::max(1, s.height() - grid_.side + 1));
    gene.turn = std::uint8_t(dice.below(kTurns));
    return gene;
}

Gene Breeder::best_drawn(int slot, int count, Dice& dice) const {
    Gene best;
    double most = -1.0;
    for (int i = 0; i < count; ++i) {
        Gene gene = drawn(slot, dice);
        if (!is_usable(gene) && i + 1 < count) continue;
        const double value = fitness_.compatibility(gene, slot).all();
        if (value > most) most = value, best = gene;
    }
    return best;
}

// A neighbour's land continued, so that no seam is visible between them.
std::optional<Gene> Breeder::gone_on(const Chromosome& c, int slot, int dx,
                                     int dy) const {
    const auto& s = grid_.slots[std::size_t(slot)];
    const int from = grid_.slot(s.layer, s.column - dx, s.row - dy);
    if (from < 0 || c.gene(from).sample < 0) return std::nullopt;
    const Gene gene = continued(c.gene(from), grid_.side, 1, dx * grid_.step(),
                                dy * grid_.step(), grid_.side);
    return is_usable(gene) ? std::optional(gene) : std::nullopt;
}

Individual Breeder::first(std::uint64_t seed, bool faithful) const {
    Individual individual{Chromosome(grid_, samples_), {}, {}, {}, {}, 0.0, 0.0};
    Chromosome& c = individual.chromosome;
    for (int slot = 0; slot < int(grid_.slots.size()); ++slot) {
        Dice dice(hash_of({seed, key("first"), std::uint64_t(slot)}));
        const auto& heir = inherited_[std::size_t(slot)];
        if (faithful && heir) {
            c.put(slot, *heir);
            continue;
        }
        std::array<Gene, kKept + 3> tried{};
        std::size_t count = 0;
        for (int i = 0; i < kKept; ++i)
            tried[count++] = best_drawn(slot, kDrawn / kKept, dice);
        if (heir) tried[count++] = *heir;
        if (const auto west = gone_on(c, slot, 1, 0)) tried[count++] = *west;
        if (const auto north = gone_on(c, slot, 0, 1)) tried[count++] = *north;
        Gene best = tried[0];
        double most = -1.0;
        for (std::size_t i = 0; i < count; ++i) {
            c.put(slot, tried[i]);
            c.cut(slot);  // its eastern and southern neighbours come later
            Compatibility value = fitness_.compatibility(tried[i], slot);
            double off = 0.0;
            int seams = 0;
            for (const bool north : {false, true})
                if (c.seam(slot, north) >= 0.0f) {
                    off += fitness_.seam(slot, c.seam(slot, north));
                    ++seams;
                }
            if (seams > 0) value.seam = off / seams;
            if (value.all() > most) most = value.all(), best = tried[i];
        }
        c.put(slot, best);
        c.cut(slot);
    }
    for (int slot = 0; slot < int(grid_.slots.size()); ++slot) c.cut(slot);
    measure(individual);
    return individual;
}

void Breeder::measure(Individual& individual) const {
    const Chromosome& c = individual.chromosome;
    individual.compatibility.resize(grid_.slots.size());
    for (int slot = 0; slot < int(grid_.slots.size()); ++slot)
        individual.compatibility[std::size_t(slot)] = fitness_.compatibility(c, slot);
    individual.blocks.resize(std::size_t(fitness_.blocks()));
    individual.regions.assign(std::size_t(fitness_.regions()), {});
    for (int block = 0; block < fitness_.blocks(); ++block) {
        individual.blocks[std::size_t(block)] = fitness_.sums(c, block);
        individual.regions[std::size_t(fitness_.region_of(block))].add(
            individual.blocks[std::size_t(block)], 1.0);
    }
    individual.similarity.resize(individual.regions.size());
    for (int r = 0; r < fitness_.regions(); ++r)
        individual.similarity[std::size_t(r)] =
            fitness_.similarity(r, individual.regions[std::size_t(r)]);
    sum_up(individual);
}

void Breeder::sum_up(Individual& individual) const {
    individual.compatible = 0.0;
    for (const Compatibility& c : individual.compatibility)
        individual.compatible += c.all();
    individual.fitness =
        (1.0 - fitness_.alpha()) * individual.compatible / double(grid_.slots.size()) +
        fitness_.alpha() * fitness_.similarity(individual.similarity);
}

// Puts the gene there if that makes the field fitter. Only the gene's neighbourhood is
// evaluated.
void Breeder::try_gene(Individual& individual, int slot, const Gene& gene) const {
    Chromosome& c = individual.chromosome;
    const Gene old = c.gene(slot);
    if (gene == old) return;
    const auto& s = grid_.slots[std::size_t(slot)];
    const std::array<int, 5> touched = {slot, grid_.slot(s.layer, s.column - 1, s.row),
                                        grid_.slot(s.layer, s.column, s.row - 1),
                                        grid_.slot(s.layer, s.column + 1, s.row),
                                        grid_.slot(s.layer, s.column, s.row + 1)};
    const auto put = [&](const Gene& g) {
        c.put(slot, g);
        c.cut(slot);
        if (touched[3] >= 0) c.cut(touched[3]);
        if (touched[4] >= 0) c.cut(touched[4]);
    };
    put(gene);
    std::array<Compatibility, 5> now;
    double gain = 0.0;
    for (std::size_t i = 0; i < touched.size(); ++i) {
        if (touched[i] < 0) continue;
        now[i] = fitness_.compatibility(c, touched[i]);
        gain += now[i].all() - individual.compatibility[std::size_t(touched[i])].all();
    }
    if (gain < kHopeless) return put(old);

    std::array<int, 9> blocks{};
    std::array<Fitness::Sums, 9> sums;
    std::size_t count = 0;
    for (int row = std::max(0, s.row - 1); row <= std::min(grid_.rows - 1, s.row + 1);
         ++row)
        for (int column = std::max(0, s.column - 1);
             column <= std::min(grid_.columns - 1, s.column + 1); ++column)
            blocks[count++] = fitness_.block(column, row);
    // The regions there, at most one for each block.
    std::array<int, 9> regions{};
    std::array<Fitness::Sums, 9> totals;
    std::size_t known = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int region = fitness_.region_of(blocks[i]);
        const auto at =
            std::size_t(std::find(regions.begin(), regions.begin() + known, region) -
                        regions.begin());
        if (at == known) {
            regions[known] = region;
            totals[known++] = individual.regions[std::size_t(region)];
        }
        sums[i] = fitness_.sums(c, blocks[i]);
        totals[at].add(individual.blocks[std::size_t(blocks[i])], -1.0);
        totals[at].add(sums[i], 1.0);
    }
    std::array<double, 9> similar{};
    double change = 0.0;
    for (std::size_t i = 0; i < known; ++i) {
        similar[i] = fitness_.similarity(regions[i], totals[i]);
        change += fitness_.share(regions[i]) *
                  (similar[i] - individual.similarity[std::size_t(regions[i])]);
    }
    const double fitter = (1.0 - fitness_.alpha()) * gain / double(grid_.slots.size()) +
                          fitness_.alpha() * change;
    if (!(fitter > 0.0)) return put(old);

    for (std::size_t i = 0; i < touched.size(); ++i)
        if (touched[i] >= 0) individual.compatibility[std::size_t(touched[i])] = now[i];
    for (std::size_t i = 0; i < count; ++i)
        individual.blocks[std::size_t(blocks[i])] = sums[i];
    for (std::size_t i = 0; i < known; ++i) {
        individual.regions[std::size_t(regions[i])] = totals[i];
        individual.similarity[std::size_t(regions[i])] = similar[i];
    }
    individual.compatible += gain;
    individual.fitness += fitter;
}

// Horizontal offset, towards a position where the sample's features lie as the pattern's
// do.
Gene Breeder::shifted(const Gene& gene, int slot, Dice& dice) const {
    Gene best = gene;
    double most = -1.0;
    for (int i = 0; i < kShifts; ++i) {
        Gene moved = gene;
        moved.x += int(std::lround(dice.normal() * grid_.side / 3.0));
        moved.y += int(std::lround(dice.normal() * grid_.side / 3.0));
        moved = kept_inside(moved, grid_.side, sample(moved));
        const double value = fitness_.compatibility(moved, slot).all();
        if (value > most && is_usable(moved)) most = value, best = moved;
    }
    return best;
}

// Rotation, mostly to the turn that faces the same way as the pattern.
Gene Breeder::turned(const Gene& gene, int slot, Dice& dice) const {
    Gene best = gene;
    double most = -1.0;
    for (int turn = 0; turn < kTurns; ++turn) {
        if (turn == gene.turn) continue;
        Gene other = gene;
        other.turn = std::uint8_t(turn);
        const double value =
            fitness_.compatibility(other, slot).all() + 0.1 * dice.unit();
        if (value > most) most = value, best = other;
    }
    return best;
}

// Vertical scale, from a Gaussian around the value that gives the pattern's range.
Gene Breeder::scaled(const Gene& gene, int slot, Dice& dice) const {
    Gene other = gene;
    const double own = fitness_.range_of(gene), asked = fitness_.range_of(slot);
    const double wanted = own > 0.0 ? gene.scale * asked / own : 1.0;
    other.scale = float(
        std::clamp(wanted * std::exp(0.2 * dice.normal()), 1.0 / kMostScale, kMostScale));
    return other;
}

std::optional<Gene> Breeder::mutated(const Individual& individual, int slot,
                                     Dice& dice) const {
    const Compatibility& c = individual.compatibility[std::size_t(slot)];
    const Gene& gene = individual.chromosome.gene(slot);
    const auto& heir = inherited_[std::size_t(slot)];
    // The more a smart operator is needed, the more likely it is; others have constant
    // odds.
    const std::array<double, 7> chances = {
        0.2 * (1.0 - c.slope),           // scale
        0.1 + 1.0 - c.angle,             // turn
        0.2 + 1.0 - c.shape,             // shift
        0.4,                             // random
        0.2 + 2.0 * (1.0 - c.seam),      // go on
        heir ? 0.2 : 0.0,                // inherit
        gene.scale != 1.0f ? 0.1 : 0.0,  // reset
    };
    double at = dice.unit() * std::accumulate(chances.begin(), chances.end(), 0.0);
    std::size_t chosen = 0;
    while (chosen + 1 < chances.size() && at >= chances[chosen]) at -= chances[chosen++];
    switch (Operator(chosen)) {
        case Operator::kScale:
            return scaled(gene, slot, dice);
        case Operator::kTurn:
            return turned(gene, slot, dice);
        case Operator::kShift:
            return shifted(gene, slot, dice);
        case Operator::kRandom:
            return best_drawn(slot, kDrawn / kKept, dice);
        case Operator::kGoOn: {
            const auto [dx, dy] = kWays[std::size_t(dice.below(4))];
            return gone_on(individual.chromosome, slot, dx, dy);
        }
        case Operator::kInherit:
            return heir;
        case Operator::kReset: {
            Gene other = gene;
            other.scale = 1.0f;
            return other;
        }
    }
    return std::nullopt;
}

void Breeder::mutate(Individual& individual, std::uint64_t seed) const {
    for (int slot = 0; slot < int(grid_.slots.size()); ++slot) {
        Dice dice(hash_of({seed, key("mutate"), std::uint64_t(slot)}));
        const double similar =
            individual.similarity[std::size_t(fitness_.region_of_slot(slot))];
        const double compatible = individual.compatibility[std::size_t(slot)].all();
        const double chance =
            options_.mutation *
            (0.5 + (1.0 - similar) / 4.0 + (1.0 - compatible) / 4.0);  // eq. IV.15
        if (dice.unit() >= chance) continue;
        if (const auto gene = mutated(individual, slot, dice))
            if (is_usable(*gene)) try_gene(individual, slot, *gene);
    }
    sum_up(individual);
}

// Copies a rectangle of another individual's genes (section IV.3.3.5), extended by genes
// that continue the same land, so that no feature is cut in two (a wish of section
// VII.10). Each gene is taken only if it makes the field fitter.
void Breeder::cross(Individual& child, const Individual& other,
                    std::uint64_t seed) const {
    Dice dice(hash_of({seed, key("cross")}));
    const int most = std::max(1, std::min({grid_.columns, grid_.rows, options_.crossed}));
    const int columns = 1 + dice.below(most), rows = 1 + dice.below(most);
    const int column0 = dice.below(std::max(1, grid_.columns - columns + 1)),
              row0 = dice.below(std::max(1, grid_.rows - rows + 1));
    std::vector<int> copied;
    std::vector<bool> is_copied(grid_.slots.size());
    const auto copy = [&](int slot) {
        if (slot < 0 || is_copied[std::size_t(slot)]) return;
        is_copied[std::size_t(slot)] = true, copied.push_back(slot);
    };
    for (int layer = 0; layer < int(grid_.types.size()); ++layer)
        for (int row = row0; row < std::min(grid_.rows, row0 + rows); ++row)
            for (int column = column0;
                 column < std::min(grid_.columns, column0 + columns); ++column)
                copy(grid_.slot(layer, column, row));
    const std::size_t enough = 4 * copied.size();
    for (std::size_t i = 0; i < copied.size() && copied.size() < enough; ++i) {
        const auto& s = grid_.slots[std::size_t(copied[i])];
        for (const auto [dx, dy] : kWays) {
            const int next = grid_.slot(s.layer, s.column + dx, s.row + dy);
            if (next >= 0 &&
                gone_on(other.chromosome, next, dx, dy) == other.chromosome.gene(next))
                copy(next);
        }
    }
    for (const int slot : copied) try_gene(child, slot, other.chromosome.gene(slot));
    sum_up(child);
}

Generation generation_of(const std::vector<Individual>& population,
                         const Fitness& fitness) {
    const Individual& best = population.front();
    Generation g{best.fitness, best.compatible / double(fitness.grid().slots.size()),
                 fitness.similarity(best.similarity), 0.0};
    for (const Individual& i : population)
        g.mean_fitness += i.fitness / double(population.size());
    return g;
}

}  // namespace

Evolved evolved(const Fitness& fitness, const std::vector<std::optional<Gene>>& inherited,
                const EvolutionOptions& options, std::uint64_t seed, Progress& progress) {
    const Breeder breeder(fitness, inherited, options);
    const int n = std::max(1, options.population);
    std::vector<std::optional<Individual>> made{std::size_t(n)};
    parallel_for(n, [&](int i) {
        made[std::size_t(i)] = breeder.first(hash_of({seed, std::uint64_t(i)}), i == 0);
    });
    std::vector<Individual> population;
    for (auto& individual : made) population.push_back(std::move(*individual));
    const auto rank = [&] {
        std::ranges::stable_sort(population, std::greater<>{}, &Individual::fitness);
    };
    rank();
    std::vector<Generation> generations = {generation_of(population, fitness)};
    const int elite = options.cycles > 0 ? std::max(1, int(options.elitism * n)) : n;
    const int chosen = std::max(1, int(std::ceil(options.selection * n)));
    for (int cycle = 0; cycle < options.cycles; ++cycle) {
        progress.report(double(cycle) / options.cycles);
        const std::vector<Individual> parents(population.begin(),
                                              population.begin() + chosen);
        parallel_for(n, [&](int i) {
            const std::uint64_t h =
                hash_of({seed, key("cycle"), std::uint64_t(cycle), std::uint64_t(i)});
            Individual& own = population[std::size_t(i)];
            if (i >= chosen) own = parents[std::size_t(i) % parents.size()];
            // The fittest are kept: a trial can only make them fitter.
            if (i >= elite)
                breeder.cross(own, parents[std::size_t(mix(h) % parents.size())], h);
            breeder.mutate(own, h);
        });
        rank();
        generations.push_back(generation_of(population, fitness));
        progress.figure(fmt::format("fitness {:.3f}", generations.back().fitness));
    }
    progress.report(1.0);
    return {std::move(population.front().chromosome), std::move(generations)};
}

}  // namespace cydonia::genetic
