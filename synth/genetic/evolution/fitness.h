#pragma once

#include <array>
#include <memory>
#include <vector>

#include "field/field.h"
#include "synth/genetic/evolution/chromosome.h"
#include "synth/genetic/evolution/genes.h"
#include "synth/genetic/evolution/samples.h"
#include "synth/statistics/similarity.h"

namespace cydonia::genetic {

// Geometric compatibility of a gene (eq. IV.14), each 0 to 1. Two terms go beyond the
// thesis: `shape`, of 3x3 parts of the gene, because the thesis names its absence as the
// cause of tiling (section VI.3.2), and `seam`, how well seams with neighbours can be
// hidden.
struct Compatibility {
    double elevation = 1.0, slope = 1.0, angle = 1.0, shape = 1.0, seam = 1.0;
    double all() const { return (elevation + slope + angle + shape + seam) / 5.0; }
};

// The large shape of a chunk: the means of its 3x3 parts in metres, row by row from the
// north-west.
struct ChunkShape {
    std::array<double, 9> parts{};
    double mean() const;
    double east() const, north() const;  // metres of rise across the whole chunk
};

// The regions of the map on the cells of one level.
struct Regions {
    Field<int> at;
    std::vector<int> types;  // of each region, as indices in the library
    std::vector<std::size_t> cells;
};

// The fitness of height fields of one level (section IV.3.3.6).
class Fitness {
  public:
    // What a height field must follow of the pattern. The base level has no coarser land
    // whose shape it could follow, only the elevation of its regions.
    enum class Follows { kShape, kElevation };
    // The arguments must outlive it. `pattern` is the coarser level's land on this
    // level's cells.
    Fitness(const GeneGrid& grid, const LevelSamples& samples,
            const Field<float>& pattern, const Regions& regions, Follows follows,
            double alpha);

    Compatibility compatibility(const Chromosome& chromosome, int slot) const;
    // Of a gene that is not in the field yet, so without seams.
    Compatibility compatibility(const Gene& gene, int slot) const;
    // How well a seam with a difference of `off` metres can be hidden, 0 to 1.
    double seam(int slot, double off) const;
    double range_of(int slot) const;  // of the pattern there: sum of |east| and |north|
    double range_of(const Gene& gene) const;

    // Power sums of elevation, slope and curvature over a block. With them the change of
    // a region's statistics by a mutation costs time for its gene only, not for the whole
    // field.
    struct Sums {
        double count = 0.0;
        std::array<std::array<double, 4>, 3> powers{};
        void add(const Sums& other, double sign);
    };
    int blocks() const { return int(block_regions_.size()); }
    int block(int column, int row) const { return row * grid_->columns + column; }
    int region_of(int block) const { return block_regions_[std::size_t(block)]; }
    int region_of_slot(int slot) const;
    Sums sums(const Chromosome& chromosome, int block) const;

    double similarity(int region, const Sums& sums) const;
    // The mean of the regions' similarities, weighted by area.
    double similarity(const std::vector<double>& of_regions) const;
    int regions() const { return int(regions_->types.size()); }
    double share(int region) const { return shares_[std::size_t(region)]; }
    double alpha() const { return alpha_; }
    const GeneGrid& grid() const { return *grid_; }
    const LevelSamples& samples() const { return *samples_; }
    const Field<float>& pattern() const { return *pattern_; }

  private:
    struct TypeFacts {
        double elevation = 1.0, slope = 1.0;  // a quarter of their ranges
        double shape = 1.0, detail = 1.0;     // half their root mean squares, metres
        double middle = 0.0;                  // mean elevation
        bool absolute = true;                 // some samples have absolute elevations
        int in_library = -1;
    };
    ChunkShape shape_of(const Gene& gene) const;
    Compatibility of_shapes(const ChunkShape& own, const ChunkShape& asked,
                            const TypeFacts& type, bool absolute) const;
    void learn_types();
    void learn_pattern();
    void learn_blocks();
    const TypeFacts& facts(int slot) const;
    statistics::Analysis analysis_of_sums(const Sums& sums, int type) const;

    const GeneGrid* grid_;
    const LevelSamples* samples_;
    const Field<float>* pattern_;
    const Regions* regions_;
    Follows follows_;
    double alpha_;
    std::vector<TypeFacts> types_;
    std::vector<ChunkShape> asked_;  // shape of the pattern at each slot
    std::vector<int> block_regions_;
    std::vector<double> shares_;
    std::unique_ptr<statistics::Library> library_;
};

}  // namespace cydonia::genetic
