#include "synth/genetic/evolution/chromosome.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cydonia::genetic {

Chromosome::Chromosome(const GeneGrid& grid, const LevelSamples& samples)
    : grid_(&grid),
      samples_(&samples),
      genes_(grid.slots.size()),
      cuts_(2 * grid.slots.size() * std::size_t(grid.side)),
      seams_(2 * grid.slots.size(), -1.0f) {}

Chromosome::View Chromosome::view(int slot) const {
    const Gene& gene = genes_[std::size_t(slot)];
    const Sample& sample = samples_->all[std::size_t(gene.sample)];
    const Field<float>& detail = sample.land->detail;
    const Layout layout = layout_of(gene, grid_->side, detail.width());
    return {detail.data() + layout.start, layout.east, layout.south,
            sample.gain * gene.scale};
}

float Chromosome::cut_between(const View& before, const View& after, bool north,
                              std::int8_t* path) const {
    constexpr int kMost = 64;
    const int side = grid_->side, overlap = std::min(grid_->overlap, kMost - 1),
              step = grid_->step();
    // A cut at c gives cells below c to the gene before it. The feathered part stays
    // inside the overlap.
    const int low = std::min(1, overlap / 2), high = overlap - low;
    const auto difference = [&](int cell, int along) {
        cell = std::clamp(cell, 0, overlap - 1);
        const float d = north ? before.at(along, step + cell) - after.at(along, cell)
                              : before.at(step + cell, along) - after.at(cell, along);
        return d * d;
    };
    std::array<float, kMost> cost{}, next{};
    std::array<std::array<std::int8_t, kMost>, kMostSide>
        from;  // every value that is read was set before
    for (int along = 0; along < side; ++along) {
        std::array<float, kMost + 1> d{};
        for (int c = 0; c <= overlap; ++c) d[std::size_t(c)] = difference(c, along);
        for (int c = low; c <= high; ++c) {
            int best = c;
            for (int other = std::max(low, c - 1); other <= std::min(high, c + 1);
                 ++other)
                if (cost[std::size_t(other)] < cost[std::size_t(best)]) best = other;
            from[std::size_t(along)][std::size_t(c)] = std::int8_t(best);
            next[std::size_t(c)] = cost[std::size_t(best)] +
                                   d[std::size_t(std::max(0, c - 1))] + d[std::size_t(c)];
        }
        cost = next;
    }
    int c = low;
    for (int other = low; other <= high; ++other)
        if (cost[std::size_t(other)] < cost[std::size_t(c)]) c = other;
    const float total = cost[std::size_t(c)];
    for (int along = side - 1; along >= 0; --along) {
        path[along] = std::int8_t(c);
        c = from[std::size_t(along)][std::size_t(c)];
    }
    return std::sqrt(total / float(2 * side));
}

void Chromosome::cut(int slot) {
    const auto& s = grid_->slots[std::size_t(slot)];
    for (const bool north : {false, true}) {
        const int before = grid_->slot(s.layer, s.column - !north, s.row - north);
        std::int8_t* path =
            cuts_.data() + (2 * std::size_t(slot) + north) * std::size_t(grid_->side);
        seams_[2 * std::size_t(slot) + north] =
            before < 0 ? -1.0f : cut_between(view(before), view(slot), north, path);
    }
}

float Chromosome::share(int cut, int cell) const {
    return std::clamp(float((cell + 0.5 - cut) / kFeather + 0.5), 0.0f, 1.0f);
}

// The detail of a row of genes of a layer at a cell (x, y) of the field.
float Chromosome::in_row(int layer, int column, int row, int x, int y) const {
    const int slot = grid_->slot(layer, column, row);
    const int step = grid_->step(), cx = x - column * step, cy = y - row * step;
    const float own = view(slot).at(cx, cy);
    const int west = cx < grid_->overlap ? grid_->slot(layer, column - 1, row) : -1;
    if (west < 0) return own;
    const float s = share(
        cuts_[2 * std::size_t(slot) * std::size_t(grid_->side) + std::size_t(cy)], cx);
    return s == 1.0f ? own : s * own + (1.0f - s) * view(west).at(cx + step, cy);
}

float Chromosome::value(int layer, int column, int row, int x, int y) const {
    const int step = grid_->step(), cx = x - column * step, cy = y - row * step;
    const int slot = grid_->slot(layer, column, row);
    const int north = cy < grid_->overlap ? grid_->slot(layer, column, row - 1) : -1;
    if (north < 0) return in_row(layer, column, row, x, y);
    const float s = share(
        cuts_[(2 * std::size_t(slot) + 1) * std::size_t(grid_->side) + std::size_t(cx)],
        cy);
    if (s == 1.0f) return in_row(layer, column, row, x, y);
    return s * in_row(layer, column, row, x, y) +
           (1.0f - s) * in_row(layer, column, row - 1, x, y);
}

void Chromosome::detail(int x, int y, int width, int height, float* values) const {
    std::fill_n(values, std::size_t(width) * std::size_t(height), 0.0f);
    const int step = grid_->step(), overlap = grid_->overlap;
    const auto last = [&](int cell, int count) {
        return std::min(cell / step, count - 1);
    };
    for (int row = last(y, grid_->rows); row <= last(y + height - 1, grid_->rows); ++row)
        for (int column = last(x, grid_->columns);
             column <= last(x + width - 1, grid_->columns); ++column)
            for (std::size_t layer = 0; layer < grid_->types.size(); ++layer) {
                const int slot = grid_->slot(int(layer), column, row);
                if (slot < 0) continue;
                const View own = view(slot);
                const Field<float>& weights = grid_->weights[layer];
                const int x0 = std::max(x, column * step),
                          x1 = column + 1 < grid_->columns
                                   ? std::min(x + width, (column + 1) * step)
                                   : x + width;
                const int y0 = std::max(y, row * step),
                          y1 = row + 1 < grid_->rows
                                   ? std::min(y + height, (row + 1) * step)
                                   : y + height;
                for (int j = y0; j < y1; ++j) {
                    float* out = values + std::size_t(j - y) * std::size_t(width);
                    const int cy = j - row * step;
                    for (int i = x0; i < x1; ++i) {
                        const float w = weights(i, j);
                        if (w == 0.0f) continue;
                        const int cx = i - column * step;
                        out[i - x] += w * (cx >= overlap && cy >= overlap
                                               ? own.at(cx, cy)
                                               : value(int(layer), column, row, i, j));
                    }
                }
            }
}

int Chromosome::owner(int layer, int x, int y) const {
    const int step = grid_->step();
    int column = std::min(x / step, grid_->columns - 1),
        row = std::min(y / step, grid_->rows - 1);
    const auto side = std::size_t(grid_->side);
    const int slot = grid_->slot(layer, column, row);
    if (slot < 0) return -1;
    const int cx = x - column * step, cy = y - row * step;
    if (cy < grid_->overlap && grid_->slot(layer, column, row - 1) >= 0 &&
        share(cuts_[(2 * std::size_t(slot) + 1) * side + std::size_t(cx)], cy) < 0.5f)
        --row;
    const int here = grid_->slot(layer, column, row);
    const int y_here = y - row * step;
    if (cx < grid_->overlap && grid_->slot(layer, column - 1, row) >= 0 &&
        share(cuts_[2 * std::size_t(here) * side + std::size_t(y_here)], cx) < 0.5f)
        --column;
    return grid_->slot(layer, column, row);
}

}  // namespace cydonia::genetic
