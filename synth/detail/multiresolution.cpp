#include "synth/detail/multiresolution.h"

#include <algorithm>
#include <cassert>

#include "field/parallel.h"

namespace cydonia::detail {
namespace {

constexpr int kGrain = 16;  // rows

// Each row of the result is a weighted sum of rows of two fields, those of the second
// field after those of the first.
void along_columns(const std::vector<Stencil>& stencils, const Field<float>& first,
                   const Field<float>& second, Field<float>& result) {
    const int split = first.height(), width = result.width();
    parallel_for(result.height(), kGrain, [&](int y) {
        const Stencil& s = stencils[std::size_t(y)];
        float* out = result.row(y).data();
        for (int k = 0; k < s.count; ++k) {
            const auto [index, weight] = s.taps[std::size_t(k)];
            const float* in = index < split ? first.row(index).data()
                                            : second.row(index - split).data();
            if (k == 0)
                for (int x = 0; x < width; ++x) out[x] = weight * in[x];
            else
                for (int x = 0; x < width; ++x) out[x] += weight * in[x];
        }
    });
}

// The same along rows: each row is first copied to one line, then summed value by value.
void along_rows(const std::vector<Stencil>& stencils, const Field<float>& first,
                const Field<float>& second, Field<float>& result) {
    parallel_for(result.height(), kGrain, [&](int y) {
        std::vector<float> line(std::size_t(first.width() + second.width()));
        std::ranges::copy(first.row(y), line.begin());
        if (!second.empty())
            std::ranges::copy(second.row(y), line.begin() + first.width());
        float* out = result.row(y).data();
        for (std::size_t x = 0; x < stencils.size(); ++x) {
            const Stencil& s = stencils[x];
            float sum = 0.0f;
            for (int k = 0; k < s.count; ++k)
                sum += s.taps[std::size_t(k)].weight *
                       line[std::size_t(s.taps[std::size_t(k)].index)];
            out[x] = sum;
        }
    });
}

}  // namespace

std::vector<Level> decomposed(Field<float> land, Filter filter, int levels) {
    std::vector<Level> result;
    for (int level = 0; level < levels; ++level) {
        const Field<float>& fine = level == 0 ? land : result.back().coarse;
        const int w = coarser(filter, fine.width()), h = coarser(filter, fine.height());
        const FilterBank across = filter_bank(filter, w), down = filter_bank(filter, h);
        assert(across.fine == fine.width() && down.fine == fine.height());
        Field<float> half(fine.width(), h);
        Level made{{{fine.width(), down.details}, {across.details, h}}, {w, h}};
        along_columns(down.a, fine, {}, half);
        along_columns(down.b, fine, {}, made.details.columns);
        along_rows(across.a, half, {}, made.coarse);
        along_rows(across.b, half, {}, made.details.rows);
        result.push_back(std::move(made));
    }
    return result;
}

Field<float> subdivided(const Field<float>& coarse, const Details& details,
                        Filter filter) {
    const FilterBank across = filter_bank(filter, coarse.width()),
                     down = filter_bank(filter, coarse.height());
    Field<float> wide(across.fine, coarse.height()), fine(across.fine, down.fine);
    along_rows(across.pq, coarse, details.rows, wide);
    along_columns(down.pq, wide, details.columns, fine);
    return fine;
}

Details no_details(Filter filter, int coarse_width, int coarse_height) {
    const FilterBank across = filter_bank(filter, coarse_width),
                     down = filter_bank(filter, coarse_height);
    return {{across.fine, down.details}, {across.details, coarse_height}};
}

Field<float> padded(const Field<float>& land, int width, int height) {
    const auto mirrored = [](int at, int count) {
        if (count == 1) return 0;
        const int period = 2 * (count - 1);
        at %= period;
        return std::min(at, period - at);
    };
    Field<float> result(width, height);
    for (int y = 0; y < height; ++y) {
        const auto row = land.row(mirrored(y, land.height()));
        for (int x = 0; x < width; ++x)
            result(x, y) = row[std::size_t(mirrored(x, land.width()))];
    }
    return result;
}

}  // namespace cydonia::detail
