#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/genetic/evolution/genes.h"
#include "synth/genetic/evolution/samples.h"

namespace cydonia::genetic {

// A height field as genes (section IV.3.3.4). Genes add detail to a pattern, the coarser
// level's land, which has all larger shapes. Where genes of a layer overlap, the seam
// runs where their details differ least (Efros and Freeman 2001) and is feathered over
// kFeather cells.
class Chromosome {
  public:
    static constexpr double kFeather = 2.0;

    // The arguments must outlive it. There are no genes at first.
    Chromosome(const GeneGrid& grid, const LevelSamples& samples);

    const Gene& gene(int slot) const { return genes_[std::size_t(slot)]; }
    void put(int slot, const Gene& gene) { genes_[std::size_t(slot)] = gene; }
    // Cuts the seams of a slot with its western and northern neighbours again.
    void cut(int slot);
    // The root mean square difference of the details on both sides of a seam, metres; -1
    // where there is no seam.
    float seam(int slot, bool north) const {
        return seams_[2 * std::size_t(slot) + north];
    }

    // Writes to `values`, row by row, what the genes add to the pattern at cells [x, x +
    // width) x [y, y + height).
    void detail(int x, int y, int width, int height, float* values) const;

    // The slot of the gene with the most weight at a cell of a layer.
    int owner(int layer, int x, int y) const;

  private:
    struct View {
        const float* cells;
        std::ptrdiff_t east, south;
        float gain;
        float at(int x, int y) const { return gain * cells[x * east + y * south]; }
    };
    View view(int slot) const;
    float cut_between(const View& before, const View& after, bool north,
                      std::int8_t* path) const;
    float share(int cut,
                int cell) const;  // of the later gene, `cell` cells from its start
    float in_row(int layer, int column, int row, int x, int y) const;
    float value(int layer, int column, int row, int x, int y) const;

    const GeneGrid* grid_;
    const LevelSamples* samples_;
    std::vector<Gene> genes_;
    std::vector<std::int8_t> cuts_;  // for each slot its western and its northern seam
    std::vector<float> seams_;
};

}  // namespace cydonia::genetic
