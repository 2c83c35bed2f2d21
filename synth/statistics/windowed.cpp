#include "synth/statistics/windowed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "field/parallel.h"

namespace cydonia::statistics {
namespace {

constexpr int kStrip = 64;  // columns at a time

template <class Body>
void for_strips(int width, const Body& body) {
    parallel_for((width + kStrip - 1) / kStrip, [&](int strip) {
        body(strip * kStrip, std::min(width, (strip + 1) * kStrip));
    });
}

// The largest value in each window along a line (van Herk 1992). The line is divided into
// pieces as long as a window, so that each window is the end of one piece and the
// beginning of the next.
class Largest {
  public:
    Largest(int n, int radius)
        : n_(n), radius_(radius), size_(2 * radius + 1), length_(n + 2 * size_) {
        for (auto* line : {&line_, &before_, &after_})
            line->assign(std::size_t(length_), std::numeric_limits<float>::lowest());
    }
    float& operator[](int i) { return line_[std::size_t(i + radius_)]; }
    void find() {
        for (int i = 0; i < length_; ++i) {
            const auto at = std::size_t(i);
            before_[at] = i % size_ ? std::max(before_[at - 1], line_[at]) : line_[at];
        }
        for (int i = length_ - 1; i >= 0; --i) {
            const auto at = std::size_t(i);
            const bool last = (i + 1) % size_ == 0 || i + 1 == length_;
            after_[at] = last ? line_[at] : std::max(after_[at + 1], line_[at]);
        }
    }
    float about(int i) const {
        return std::max(after_[std::size_t(i)], before_[std::size_t(i + size_ - 1)]);
    }
    int size() const { return n_; }

  private:
    int n_, radius_, size_, length_;
    std::vector<float> line_, before_, after_;
};

Field<float> largest(const Field<float>& field, int radius, float sign) {
    const int w = field.width(), h = field.height();
    Field<float> result(w, h);
    parallel_for((h + 15) / 16, [&](int block) {
        Largest line(w, radius);
        for (int y = 16 * block; y < std::min(h, 16 * block + 16); ++y) {
            for (int x = 0; x < w; ++x) line[x] = sign * field(x, y);
            line.find();
            for (int x = 0; x < w; ++x) result(x, y) = line.about(x);
        }
    });
    // The same down the columns, a strip of neighbouring columns at a time, because
    // memory is laid out in rows.
    const int size = 2 * radius + 1, length = h + 2 * size;
    for_strips(w, [&](int x0, int x1) {
        const auto n = std::size_t(x1 - x0);
        const std::vector<float> none(n, std::numeric_limits<float>::lowest());
        std::vector<float> before(std::size_t(length) * n), after(before.size());
        const auto in = [&](int i) {
            const int y = i - radius;
            return y >= 0 && y < h ? result.row(y).data() + x0 : none.data();
        };
        for (int i = 0; i < length; ++i) {
            float* own = before.data() + std::size_t(i) * n;
            const float* value = in(i);
            for (std::size_t x = 0; x < n; ++x)
                own[x] = i % size ? std::max(own[std::ptrdiff_t(x) - std::ptrdiff_t(n)],
                                             value[x])
                                  : value[x];
        }
        for (int i = length - 1; i >= 0; --i) {
            float* own = after.data() + std::size_t(i) * n;
            const float* value = in(i);
            const bool last = (i + 1) % size == 0 || i + 1 == length;
            for (std::size_t x = 0; x < n; ++x)
                own[x] = last ? value[x] : std::max(own[x + n], value[x]);
        }
        for (int y = 0; y < h; ++y) {
            const float *a = after.data() + std::size_t(y) * n,
                        *b = before.data() + std::size_t(y + size - 1) * n;
            for (std::size_t x = 0; x < n; ++x)
                result(x0 + int(x), y) = sign * std::max(a[x], b[x]);
        }
    });
    return result;
}

int overlap(int i, int radius, int n) {
    return std::min(n - 1, i + radius) - std::max(0, i - radius) + 1;
}

// Calls visit(x, y, mean) with the mean of value(x, y) over the window around each
// sample. Sums slide along rows first, then down columns (section V.4.3), in doubles.
template <class Value, class Visit>
void window_means(int w, int h, int radius, const Value& value, const Visit& visit) {
    Field<double> rows(w, h);
    parallel_for(h, 16, [&](int y) {
        double sum = 0.0;
        for (int x = 0; x < std::min(w, radius); ++x) sum += value(x, y);
        for (int x = 0; x < w; ++x) {
            if (x + radius < w) sum += value(x + radius, y);
            if (x - radius > 0) sum -= value(x - radius - 1, y);
            rows(x, y) = sum;
        }
    });
    for_strips(w, [&](int x0, int x1) {
        std::vector<double> sums(std::size_t(x1 - x0), 0.0);
        const auto add = [&](int y, double sign) {
            const double* row = rows.row(y).data() + x0;
            for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += sign * row[x];
        };
        for (int y = 0; y < std::min(h, radius); ++y) add(y, 1.0);
        for (int y = 0; y < h; ++y) {
            if (y + radius < h) add(y + radius, 1.0);
            if (y - radius > 0) add(y - radius - 1, -1.0);
            const int deep = overlap(y, radius, h);
            for (int x = x0; x < x1; ++x)
                visit(x, y, sums[std::size_t(x - x0)] / (deep * overlap(x, radius, w)));
        }
    });
}

}  // namespace

Field<float> window_mean(const Field<float>& field, int radius) {
    Field<float> result(field.width(), field.height());
    window_means(
        field.width(), field.height(), radius,
        [&](int x, int y) { return double(field(x, y)); },
        [&](int x, int y, double mean) { result(x, y) = float(mean); });
    return result;
}

Field<float> window_low(const Field<float>& field, int radius) {
    return largest(field, radius, -1.0f);
}

Field<float> window_high(const Field<float>& field, int radius) {
    return largest(field, radius, 1.0f);
}

Windowed windowed(const Terrain& terrain, int radius) {
    const Field<float>& h = terrain.heights;
    const int width = h.width(), height = h.height();
    Windowed result;
    if (h.empty()) return result;
    result.low = window_low(h, radius), result.high = window_high(h, radius);
    // Relative to the land's own height, so that squares lose nothing by rounding.
    double middle = 0.0;
    for (const float value : h) middle += value / double(h.size());
    Field<double> means(width, height);
    result.mean = result.deviation = result.east = result.north =
        Field<float>(width, height);
    window_means(
        width, height, radius, [&](int x, int y) { return h(x, y) - middle; },
        [&](int x, int y, double mean) {
            means(x, y) = mean;
            result.mean(x, y) = float(mean + middle);
        });
    window_means(
        width, height, radius,
        [&](int x, int y) { return (h(x, y) - middle) * (h(x, y) - middle); },
        [&](int x, int y, double square) {
            result.deviation(x, y) =
                float(std::sqrt(std::max(0.0, square - means(x, y) * means(x, y))));
        });
    const auto slope = [&](int x0, int y0, int x1, int y1, int n) {
        return n > 0 ? (h(x1, y1) - h(x0, y0)) / (n * terrain.spacing) : 0.0;
    };
    window_means(
        width, height, radius,
        [&](int x, int y) {
            const int a = std::max(0, x - 1), b = std::min(width - 1, x + 1);
            return slope(a, y, b, y, b - a);
        },
        [&](int x, int y, double mean) { result.east(x, y) = float(mean); });
    window_means(
        width, height, radius,
        [&](int x, int y) {
            const int a = std::max(0, y - 1), b = std::min(height - 1, y + 1);
            return slope(x, b, x, a, b - a);
        },
        [&](int x, int y, double mean) { result.north(x, y) = float(mean); });
    return result;
}

}  // namespace cydonia::statistics
