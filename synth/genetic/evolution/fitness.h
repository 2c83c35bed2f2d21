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

// Geometric compatibility of a gene (eq. IV.14), each 0 to 1. Beyond the thesis' three:
// shape, by 3x3 parts of the gene, whose want it names as the cause of its tiling
// (section VI.3.2), and how well the seams with its neighbours can be hidden.
struct Compatibility {
    double elevation = 1.0, slope = 1.0, angle = 1.0, shape = 1.0, seam = 1.0;
    double all() const { return (elevation + slope + angle + shape + seam) / 5.0; }
};

// A chunk's large shape: the means of 3x3 parts of it, metres, row by row from its
// north-west corner.
struct ChunkShape {
    std::array<double, 9> parts{};
    double mean() const;
    double east() const, north() const;  // metres of rise across the whole chunk
};

// Regions of the map at one level.
struct Regions {
    Field<int> at;
    std::vector<int> types;  // of each region, in the library
    std::vector<std::size_t> cells;
};

// What height fields of one level are judged by (section IV.3.3.6).
class Fitness {
  public:
    // The base level has no coarser land to follow in shape, only how high its regions
    // are to lie.
    enum class Follows { kShape, kElevation };
    // All must outlive it. `pattern`: the coarser level's land on this level's cells.
    Fitness(const GeneGrid& grid, const LevelSamples& samples,
            const Field<float>& pattern, const Regions& regions, Follows follows,
            double alpha);

    Compatibility compatibility(const Chromosome& chromosome, int slot) const;
    // Without seams: of a gene that is not there yet.
    Compatibility compatibility(const Gene& gene, int slot) const;
    // How well a seam that is so many metres off can be hidden.
    double seam(int slot, double off) const;
    double range_of(int slot) const;  // of the pattern there: sum of |east| and |north|
    double range_of(const Gene& gene) const;

    // Power sums of elevation, slope and curvature over a slot's own cells: what a
    // mutation changes of a region's statistics, so that it costs its gene and not the
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
    // The regions' similarities, each weighted by its area.
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
        bool absolute = true;                 // some samples' elevations are their own
        int in_library = -1;
    };
    ChunkShape shape_of(const Gene& gene) const;
    Compatibility of_shapes(const ChunkShape& own, const ChunkShape& asked,
                            const TypeFacts& type, bool absolute) const;
    void learn_types();
    void learn_pattern();
    void learn_blocks();
    const TypeFacts& facts(int slot) const;
    Analysis analysis_of_sums(const Sums& sums, int type) const;

    const GeneGrid* grid_;
    const LevelSamples* samples_;
    const Field<float>* pattern_;
    const Regions* regions_;
    Follows follows_;
    double alpha_;
    std::vector<TypeFacts> types_;
    std::vector<ChunkShape> asked_;  // of the pattern at each slot
    std::vector<int> block_regions_;
    std::vector<double> shares_;
    std::unique_ptr<Library> library_;
};

}  // namespace cydonia::genetic
