#include "synth/pareidolia/light_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"

namespace cydonia::pareidolia {

GridPoint LightFrame::position(double sample, double row) const {
    const double s = (sample - (side - 1) / 2.0) / density;
    const double t = (row - (side - 1) / 2.0) / density;
    return {centre.x + s * along.x + t * across.x, centre.y + s * along.y + t * across.y};
}

double LightFrame::sample_at(GridPoint p) const {
    const double s = (p.x - centre.x) * along.x + (p.y - centre.y) * along.y;
    return s * density + (side - 1) / 2.0;
}

double LightFrame::row_at(GridPoint p) const {
    const double t = (p.x - centre.x) * across.x + (p.y - centre.y) * across.y;
    return t * density + (side - 1) / 2.0;
}

Cell cell_of(GridPoint p) {
    // lround() would be a library call for each of the millions of samples that the
    // search for an azimuth takes.
    return {static_cast<int>(std::floor(p.x + 0.5)),
            static_cast<int>(std::floor(p.y + 0.5))};
}

LightFrame light_frame(int width, int height, double azimuth, int density) {
    LightFrame frame;
    frame.centre = {(width - 1) / 2.0, (height - 1) / 2.0};
    frame.along = {-std::sin(azimuth), std::cos(azimuth)};
    frame.across = {-frame.along.y, frame.along.x};
    frame.density = density;
    frame.side =
        2 * static_cast<int>(std::ceil(std::hypot(width, height) * density / 2.0)) + 1;
    return frame;
}

Field<std::uint8_t> rotated(const Field<std::uint8_t>& image, const LightFrame& frame) {
    Field<std::uint8_t> result(frame.side, frame.side);
    parallel_for(frame.side, 16, [&](int row) {
        for (int i = 0; i < frame.side; ++i) {
            const GridPoint p = frame.position(i, row);
            const Cell c = cell_of(p);
            if (image.contains(c.x, c.y)) result(i, row) = image(c.x, c.y);
        }
    });
    return result;
}

std::vector<Run> runs_of(const Field<std::uint8_t>& rotated) {
    std::vector<Run> runs;
    for (int y = 0; y < rotated.height(); ++y) {
        const auto row = rotated.row(y);
        auto at = row.begin();
        while ((at = std::find(at, row.end(), 1)) != row.end()) {
            const auto past = std::find(at, row.end(), 0);
            runs.push_back({y, static_cast<int>(at - row.begin()),
                            static_cast<int>(past - row.begin())});
            at = past;
        }
    }
    return runs;
}

double shortest_azimuth(const Field<std::uint8_t>& image) {
    // Half a turn is enough, because light in the opposite direction has shadows of the
    // same length.
    constexpr int kCandidates = 36;
    double best = 0.0;
    int shortest = image.width() + image.height();
    for (int i = 0; i < kCandidates; ++i) {
        const double azimuth = std::numbers::pi * i / kCandidates;
        const LightFrame frame = light_frame(image.width(), image.height(), azimuth, 1);
        int longest = 0;
        for (const Run& run : runs_of(rotated(image, frame)))
            longest = std::max(longest, run.past - run.first);
        if (longest < shortest) {
            shortest = longest;
            best = azimuth;
        }
    }
    return best;
}

}  // namespace cydonia::pareidolia
