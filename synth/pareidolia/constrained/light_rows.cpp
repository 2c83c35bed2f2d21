#include "synth/pareidolia/constrained/light_rows.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "synth/pareidolia/constrained/transpose.h"

namespace cydonia::pareidolia {

LightRows::LightRows(int width, int height, double azimuth, Stops stops) {
    // The direction of light over the ground, with y to the south. A sun on an axis stays
    // on it exactly.
    const auto straight = [](double v) { return std::abs(v) < 1e-9 ? 0.0 : v; };
    const double dx = straight(-std::sin(azimuth)), dy = straight(std::cos(azimuth));
    along_y_ = std::abs(dy) > std::abs(dx);
    const double along = along_y_ ? dy : dx, across = along_y_ ? dx : dy;
    backwards_ = along < 0.0;
    columns_ = along_y_ ? height : width;
    lines_ = along_y_ ? width : height;
    slope_ = across / along;
    step_ = std::hypot(1.0, slope_);
    const double drift = std::abs(slope_) * (columns_ - 1);
    origin_ = slope_ > 0.0 ? -std::ceil(drift) : 0.0;
    stops_ = slope_ == 0.0 || stops == Stops::kColumns ? 1 : slope_ > 0.0 ? 2 : 4;

    places_.reserve(static_cast<std::size_t>(columns_) * stops_);
    for (int i = 0; i < columns_; ++i) {
        const std::vector<Stop> of_column = crossings(i);
        for (std::size_t s = 0; s < static_cast<std::size_t>(stops_); ++s) {
            places_.push_back(of_column[std::min(s, of_column.size() - 1)]);
            places_.back().counts = s < of_column.size();
        }
    }

    // No eigenvalue of A^T A is above the greatest sum of a column of A when the sums of
    // its rows are one.
    float most = 1.0f;
    for (int i = 0; i < columns_ && stops_ > 1; ++i) {
        float sum = 1.0f;
        for (int s = 1; s < stops_; ++s) {
            const Stop& here = stop(i * stops_ + s);
            if (here.counts) sum += 1.0f - here.past;
            if (i > 0 && stop((i - 1) * stops_ + s).counts)
                sum += stop((i - 1) * stops_ + s).past;
        }
        most = std::max(most, sum);
    }
    share_ = 1.0f / most;

    spans_.resize(lines_ + static_cast<std::size_t>(std::ceil(drift)));
    parallel_for(rows(), 64, [&](int row) {
        const auto inside = [&](int column) {
            const Stop& at = stop(column * stops_);
            const int line = row + at.line;
            return line >= 0 &&
                   (line < lines_ - 1 || (line == lines_ - 1 && at.past == 0.0f));
        };
        int first = 0, past = columns_;
        while (first < columns_ && !inside(first)) ++first;
        while (past > first && !inside(past - 1)) --past;
        // Samples after the last column would lie beyond the grid.
        spans_[static_cast<std::size_t>(row)] = {
            first * stops_, past > first ? (past - 1) * stops_ + 1 : first * stops_};
    });
}

// The points where row 0 crosses the mesh from `column` to before the next one. Squares
// are split from their first corner to the opposite one.
std::vector<LightRows::Stop> LightRows::crossings(int column) const {
    const double at = origin_ + slope_ * column;
    const int line = static_cast<int>(std::floor(at));
    const double f = at - line, m = std::abs(slope_);
    const auto stop = [](int first, int second, int columns, double past, double where) {
        return Stop{first, second, static_cast<std::int8_t>(columns),
                    static_cast<float>(past), static_cast<float>(where)};
    };
    std::vector<Stop> result{stop(line, line + 1, 0, f, 0.0)};
    if (stops_ == 1) return result;
    const auto diagonal = [&](int from, double u) {
        result.push_back(stop(from, from + 1, 1, u, u));
    };
    const auto level = [&](int on, double u) { result.push_back(stop(on, on, 1, u, u)); };
    if (slope_ > 0.0) {
        if (f + m < 1.0)
            diagonal(line, f / (1.0 - m));
        else
            level(line + 1, (1.0 - f) / m);
    } else {
        diagonal(line, f / (1.0 + m));
        if (f - m < 0.0) {
            level(line, f / m);
            diagonal(line - 1, (1.0 + f) / (1.0 + m));
        }
    }
    return result;
}

GridPoint LightRows::position(double column, int row) const {
    double i = column, j = origin_ + slope_ * column + row;
    if (backwards_) {
        i = columns_ - 1 - i;
        j = lines_ - 1 - j;
    }
    return along_y_ ? GridPoint{j, i} : GridPoint{i, j};
}

// Light against the axis turns the grid by half a turn, which keeps the squares'
// diagonals.
Field<float> LightRows::turned(const Field<float>& heights) const {
    Field<float> along = along_y_ ? transposed(heights) : heights;
    if (backwards_) std::reverse(along.begin(), along.end());
    return along;
}

Field<float> LightRows::turned_back(Field<float> along) const {
    if (backwards_) std::reverse(along.begin(), along.end());
    return along_y_ ? transposed(along) : along;
}

Field<float> LightRows::sampled(const Field<float>& heights) const {
    const Field<float> along = turned(heights);
    Field<float> result(samples(), rows());
    const auto height = [&](int column, int line) {
        return along(std::min(column, columns_ - 1), std::clamp(line, 0, lines_ - 1));
    };
    parallel_for(rows(), 16, [&](int row) {
        float* out = result.data() + static_cast<std::size_t>(row) * samples();
        for (int i = span(row).first; i < span(row).past; ++i) {
            const Stop& at = stop(i);
            if (!at.counts) continue;
            const int column = i / stops_;
            out[i] = (1.0f - at.past) * height(column, row + at.line) +
                     at.past * height(column + at.columns, row + at.next_line);
        }
    });
    return result;
}

Field<float> LightRows::gathered(const Field<float>& at_samples) const {
    const auto value = [&](int sample, int row) {
        return row >= 0 && row < rows() ? at_samples(sample, row) : 0.0f;
    };
    Field<float> along(columns_, lines_);
    parallel_for(lines_, 16, [&](int line) {
        float* out = along.data() + static_cast<std::size_t>(line) * columns_;
        for (int i = 0; i < columns_; ++i) {
            float sum = 0.0f;
            for (int s = 0; s < stops_; ++s) {
                const int here = i * stops_ + s;
                const Stop& first = stop(here);
                sum += (1.0f - first.past) * value(here, line - first.line);
                const int before = here - (s == 0 ? 0 : stops_);
                if (before < 0) continue;
                const Stop& second = stop(before);
                sum += second.past * value(before, line - second.next_line);
            }
            out[i] = share_ * sum;
        }
    });
    return turned_back(std::move(along));
}

}  // namespace cydonia::pareidolia
