#include <cmath>

#include "field/parallel.h"
#include "synth/texture/height_read.h"
#include "synth/texture/places.h"
#include "synth/texture/synthesis.h"

namespace cydonia::texture {
namespace {

// Where a cell does not continue the land of its western or its northern neighbour.
constexpr std::uint8_t kWest = 1, kNorth = 2;
Field<std::uint8_t> seams(const Synthesis& land) {
    const Window& w = land.window;
    const int cell = 2 << w.level;
    Field<std::uint8_t> seam(w.width, w.height);
    const auto continues = [&](std::size_t a, std::size_t b, Step s) {
        const Place p = land.places[a], q = land.places[b];
        const Step t = kTurns(p.orientation(), s.x * cell, s.y * cell);
        return q.x == p.x + std::uint32_t(t.x) && q.y == p.y + std::uint32_t(t.y) &&
               land.offsets[a] == land.offsets[b];
    };
    parallel_for(w.height, 16, [&](int y) {
        for (int x = 0; x < w.width; ++x) {
            const std::size_t i = seam.index(x, y);
            if (x > 0 && !continues(i - 1, i, {1, 0})) seam[i] |= kWest;
            if (y > 0 && !continues(i - std::size_t(w.width), i, {0, 1}))
                seam[i] |= kNorth;
        }
    });
    return seam;
}

// Not 0 where the cells within kReadOut are not all of one land. The seam before the
// first of them is none of theirs.
Field<std::uint8_t> near_seams(const Field<std::uint8_t>& seam) {
    Field<std::uint8_t> rows(seam.width(), seam.height());
    Field<std::uint8_t> near(seam.width(), seam.height());
    parallel_for(seam.height(), 16, [&](int y) {
        for (int x = kReadOut; x < seam.width() - kReadOut; ++x) {
            std::uint8_t any = seam(x - kReadOut, y) & kNorth;
            for (int d = 1 - kReadOut; d <= kReadOut; ++d) any |= seam(x + d, y);
            rows(x, y) = any;
        }
    });
    parallel_for(seam.height() - 2 * kReadOut, 16, [&](int row) {
        const int y = row + kReadOut;
        for (int x = 0; x < seam.width(); ++x) near(x, y) = rows(x, y - kReadOut) & kWest;
        for (int d = 1 - kReadOut; d <= kReadOut; ++d)
            for (int x = 0; x < seam.width(); ++x) near(x, y) |= rows(x, y + d);
    });
    return near;
}

struct Weights {
    static constexpr int kSide = 2 * kReadOut + 1;
    float of[kSide][kSide];
    Weights() {
        double sum = 0.0;
        constexpr double kSigma = 1.2;  // cells
        const auto gauss = [](int x, int y) {
            return std::exp(-(x * x + y * y) / (2.0 * kSigma * kSigma));
        };
        for (int y = -kReadOut; y <= kReadOut; ++y)
            for (int x = -kReadOut; x <= kReadOut; ++x) sum += gauss(x, y);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                of[y][x] = float(gauss(x - kReadOut, y - kReadOut) / sum);
    }
};

}  // namespace

Field<float> heights_of(const Database& database, const Synthesis& land) {
    static const Weights weights;
    const Window& w = land.window;
    const Level& level = database.levels[std::size_t(w.level)];
    const int cell = 2 << w.level;
    const float metres = static_cast<float>(database.unit);
    const Field<std::uint8_t> crossfade = near_seams(seams(land));
    Field<float> heights(w.width - 2 * kReadOut, w.height - 2 * kReadOut);
    parallel_for(heights.height(), 8, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            const int cx = x + kReadOut, cy = y + kReadOut;
            if (!crossfade(cx, cy)) {
                heights(x, y) = height_at(level, w.level, spot_of(land.places(cx, cy))) +
                                metres * float(land.offsets(cx, cy));
                continue;
            }
            float sum = 0.0f;
            for (int dy = -kReadOut; dy <= kReadOut; ++dy) {
                for (int dx = -kReadOut; dx <= kReadOut; ++dx) {
                    const std::size_t i = land.places.index(cx + dx, cy + dy);
                    const Spot spot = spot_of(land.places[i]);
                    const Step back = kTurns(spot.orientation, -dx * cell, -dy * cell);
                    sum += weights.of[dy + kReadOut][dx + kReadOut] *
                           (height_at(level, w.level, spot.moved(back)) +
                            metres * float(land.offsets[i]));
                }
            }
            heights(x, y) = sum;
        }
    });
    return heights;
}

}  // namespace cydonia::texture
