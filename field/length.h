#pragma once

namespace cydonia {

// A length in metres or as a fraction of the terrain's width (its west-east extent),
// never in cells. In scene files: 300.0 or "5.5 %".
struct Length {
    double metres = 0.0;
    double fraction = 0.0;

    double in(double width_metres) const { return metres + fraction * width_metres; }
    bool operator==(const Length&) const = default;
};

constexpr Length metres(double value) { return {value, 0.0}; }
constexpr Length of_width(double fraction) { return {0.0, fraction}; }
// Rusnell 2009 counts lengths, heights and costs in cells of a 512-sample grid
// (docs/papers.md, Rusnell 1).
constexpr Length thesis_units(double value) { return {0.0, value / 512.0}; }

}  // namespace cydonia
