#include "field/sampled.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "field/parallel.h"

namespace cydonia {
namespace {

// Keys, "Cubic convolution interpolation for digital image processing", 1981, eq. 4.
double keys(double x) {
    x = std::abs(x);
    if (x < 1.0) return (1.5 * x - 2.5) * x * x + 1.0;
    if (x < 2.0) return ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0;
    return 0.0;
}

// The weights of the cells first, first + 1, ... in one sample. They sum to 1.
struct Taps {
    int first = 0;
    std::vector<double> weights;
};

// The samples along one axis of a grid.
struct Axis {
    double begin, cell;
    int first;  // sample
    int from;   // the cell of the grid that is the first in memory
};

Taps taps_at(const Axis& axis, int sample) {
    const double stretch = std::max(1.0, axis.cell);
    const double at = axis.begin + (sample + 0.5) * axis.cell - 0.5;  // in centres
    Taps taps;
    taps.first = static_cast<int>(std::ceil(at - 2.0 * stretch));
    double sum = 0.0;
    for (int i = taps.first; i <= at + 2.0 * stretch; ++i)
        sum += taps.weights.emplace_back(keys((i - at) / stretch));
    for (double& weight : taps.weights) weight /= sum;
    taps.first -= axis.from;
    return taps;
}

std::vector<Taps> all_taps(const Axis& axis, int samples) {
    std::vector<Taps> taps;
    for (int i = 0; i < samples; ++i) taps.push_back(taps_at(axis, axis.first + i));
    return taps;
}

// Resamples the rows [top, bottom). The result is transposed, so that two calls resample
// both axes.
Field<float> across(const Field<float>& field, int top, int bottom,
                    const std::vector<Taps>& columns) {
    Field<float> result(bottom - top, static_cast<int>(columns.size()));
    parallel_for(bottom - top, 16, [&](int y) {
        const auto row = field.row(top + y);
        const int last = field.width() - 1;
        for (int x = 0; x < result.height(); ++x) {
            const auto& [first, weights] = columns[std::size_t(x)];
            double sum = 0.0;
            for (std::size_t k = 0; k < weights.size(); ++k)
                sum += weights[k] *
                       double(row[std::size_t(std::clamp(first + int(k), 0, last))]);
            result(y, x) = static_cast<float>(sum);
        }
    });
    return result;
}

}  // namespace

Field<float> sampled(const Field<float>& from, const SampleGrid& grid, int width,
                     int height) {
    // Only the rows that contribute to some sample are resampled.
    const double reach = 2.0 * std::max(1.0, grid.cell) + 1.0;
    const double north = grid.north + grid.row * grid.cell - grid.from_row;
    const int top =
        std::clamp(static_cast<int>(std::floor(north - reach)), 0, from.height() - 1);
    const int bottom =
        std::clamp(static_cast<int>(std::ceil(north + height * grid.cell + reach)),
                   top + 1, from.height());
    const Axis east{grid.west, grid.cell, grid.column, grid.from_column};
    const Axis south{grid.north, grid.cell, grid.row, grid.from_row + top};
    const Field<float> columns = across(from, top, bottom, all_taps(east, width));
    return across(columns, 0, columns.height(), all_taps(south, height));
}

}  // namespace cydonia
