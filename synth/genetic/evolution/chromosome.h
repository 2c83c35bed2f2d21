#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/genetic/evolution/genes.h"
#include "synth/genetic/evolution/samples.h"

namespace cydonia::genetic {

// A height field as genes (section IV.3.3.4): detail for the coarser level's land, the
// pattern, which has all larger shapes. Where genes of a layer overlap, each seam runs
// where their details differ least (Efros and Freeman 2001) and is faded over kFeather
// cells.
class Chromosome {
  public:
    static constexpr double kFeather = 2.0;

    // All must outlive it. Genes are nowhere yet.
    Chromosome(const GeneGrid& grid, const LevelSamples& samples);

    const Gene& gene(int slot) const { return genes_[std::size_t(slot)]; }
    void put(int slot, const Gene& gene) { genes_[std::size_t(slot)] = gene; }
    // The seams of a slot with its western and northern neighbours, anew.
    void cut(int slot);
    // Root mean square of what the details on both sides of a seam differ by along it,
    // metres; -1 where there is no seam.
    float seam(int slot, bool north) const {
        return seams_[2 * std::size_t(slot) + north];
    }

    // What the genes add to the pattern: cells [x, x + width) x [y, y + height), rows of
    // `width`.
    void detail(int x, int y, int width, int height, float* values) const;

    // The gene whose land a cell of a layer has, the one with more weight there.
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
    float share(int cut, int cell) const;  // of the later gene, `cell` from its start
    float in_row(int layer, int column, int row, int x, int y) const;
    float value(int layer, int column, int row, int x, int y) const;

    const GeneGrid* grid_;
    const LevelSamples* samples_;
    std::vector<Gene> genes_;
    std::vector<std::int8_t> cuts_;  // a slot's western seam, then its northern one
    std::vector<float> seams_;
};

}  // namespace cydonia::genetic
