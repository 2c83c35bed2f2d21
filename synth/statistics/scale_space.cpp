#include "synth/statistics/scale_space.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::statistics {
namespace {

constexpr double kFinest = 1.0, kCoarsest = 16.0, kStep = 1.4142135623730951;  // sqrt(2)

int mirrored(int i, int n) {
    if (n == 1) return 0;
    const int period = 2 * n - 2;
    i = ((i % period) + period) % period;
    return i < n ? i : period - i;
}

std::vector<float> gaussian(double deviation) {
    const int radius = int(std::ceil(4.0 * deviation));
    std::vector<float> weights(std::size_t(2 * radius + 1));
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i)
        sum += std::exp(-0.5 * i * i / (deviation * deviation));
    for (int i = -radius; i <= radius; ++i)
        weights[std::size_t(i + radius)] =
            float(std::exp(-0.5 * i * i / (deviation * deviation)) / sum);
    return weights;
}

}  // namespace

namespace {

// Adds to sum[x] the middle weight times line[0][x], and each other weight times both
// lines at its distance. Two weights at a time, so that sums are read and written half as
// often.
template <class Line>
void weigh(const std::vector<float>& weights, int n, const Line& line, float* sum) {
    const int radius = int(weights.size()) / 2;
    const float* weight = weights.data() + radius;
    const float* middle = line(0);
    for (int x = 0; x < n; ++x) sum[x] = weight[0] * middle[x];
    int k = 1;
    for (; k + 1 <= radius; k += 2) {
        const float *a = line(-k), *b = line(k), *c = line(-k - 1), *d = line(k + 1);
        const float u = weight[k], v = weight[k + 1];
        for (int x = 0; x < n; ++x) sum[x] += u * (a[x] + b[x]) + v * (c[x] + d[x]);
    }
    for (; k <= radius; ++k) {
        const float *a = line(-k), *b = line(k);
        for (int x = 0; x < n; ++x) sum[x] += weight[k] * (a[x] + b[x]);
    }
}

}  // namespace

Field<float> blurred(const Field<float>& field, double deviation) {
    const std::vector<float> weights = gaussian(deviation);
    const int radius = int(weights.size()) / 2, w = field.width(), h = field.height();
    Field<float> result(w, h);
    // Columns are blurred first, row by row, so that the rows that are read stay in the
    // cache.
    parallel_for((h + 15) / 16, [&](int block) {
        std::vector<float> wide(std::size_t(w + 2 * radius));
        for (int y = 16 * block; y < std::min(h, 16 * block + 16); ++y) {
            float* line = wide.data() + radius;
            weigh(
                weights, w, [&](int k) { return field.row(mirrored(y + k, h)).data(); },
                line);
            for (int x = 1; x <= radius; ++x) {
                line[-x] = line[mirrored(-x, w)];
                line[w - 1 + x] = line[mirrored(w - 1 + x, w)];
            }
            weigh(
                weights, w, [&](int k) { return line + k; }, result.row(y).data());
        }
    });
    return result;
}

double deviation_at(double place) { return kFinest * std::exp2(0.5 * place); }

std::vector<Scale> scale_space(const Field<float>& field) {
    std::vector<Scale> scales;
    const double coarsest =
        std::min(kCoarsest, std::min(field.width(), field.height()) / 8.0);
    for (double deviation = kFinest; deviation <= coarsest * 1.01; deviation *= kStep) {
        // The variances of successive blurs add up, so each scale is made from the one
        // before, with weights that are narrower by a factor of sqrt(2).
        const double before = scales.empty() ? 0.0 : scales.back().deviation;
        const double more = std::sqrt(deviation * deviation - before * before);
        scales.push_back(
            {deviation, blurred(scales.empty() ? field : scales.back().land, more)});
    }
    return scales;
}

}  // namespace cydonia::statistics
