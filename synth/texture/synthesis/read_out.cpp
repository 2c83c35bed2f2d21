#include <algorithm>
#include <cmath>
#include <limits>

#include "field/parallel.h"
#include "synth/texture/synthesis/height_read.h"
#include "synth/texture/synthesis/origins.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {
namespace {

constexpr int kFade = 2;  // radius of a cross-fade, cells
static_assert(kReadOut == kFade + 1);

// Marks cells that do not continue the land of their western or their northern neighbour.
// Within one patch offsets change smoothly.
constexpr std::uint8_t kWest = 1, kNorth = 2;
Field<std::uint8_t> seams(const Synthesis& land) {
    const Window& w = land.window;
    const int cell = 2 << w.level;
    Field<std::uint8_t> seam(w.width, w.height);
    const auto continues = [&](std::size_t a, std::size_t b, Step s) {
        const Origin p = land.origins[a], q = land.origins[b];
        const Step t = kTurns(p.orientation(), s.x * cell, s.y * cell);
        return q.x == p.x + std::uint32_t(t.x) && q.y == p.y + std::uint32_t(t.y);
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

// Not 0 where the cells within kFade are not all of one patch. A seam before the first of
// them does not count.
Field<std::uint8_t> near_seams(const Field<std::uint8_t>& seam) {
    Field<std::uint8_t> rows(seam.width(), seam.height());
    Field<std::uint8_t> near(seam.width(), seam.height());
    parallel_for(seam.height(), 16, [&](int y) {
        for (int x = kFade; x < seam.width() - kFade; ++x) {
            std::uint8_t any = seam(x - kFade, y) & kNorth;
            for (int d = 1 - kFade; d <= kFade; ++d) any |= seam(x + d, y);
            rows(x, y) = any;
        }
    });
    parallel_for(seam.height() - 2 * kFade, 16, [&](int row) {
        const int y = row + kFade;
        for (int x = 0; x < seam.width(); ++x) near(x, y) = rows(x, y - kFade) & kWest;
        for (int d = 1 - kFade; d <= kFade; ++d)
            for (int x = 0; x < seam.width(); ++x) near(x, y) |= rows(x, y + d);
    });
    return near;
}

struct Weights {
    static constexpr int kSide = 2 * kFade + 1;
    float of[kSide][kSide];
    Weights() {
        double sum = 0.0;
        constexpr double kSigma = 1.0;  // cells
        const auto gauss = [](int x, int y) {
            return std::exp(-(x * x + y * y) / (2.0 * kSigma * kSigma));
        };
        for (int y = -kFade; y <= kFade; ++y)
            for (int x = -kFade; x <= kFade; ++x) sum += gauss(x, y);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                of[y][x] = float(gauss(x - kFade, y - kFade) / sum);
    }
};

// Inside a patch the height is the exemplar's; near seams it is a cross-fade of all
// patches around.
struct ReadOut {
    Field<float> heights;       // without the outermost kFade cells
    Field<std::uint8_t> faded;  // of the whole window
};

ReadOut read_out(const Database& database, const Synthesis& land) {
    static const Weights weights;
    const Window& w = land.window;
    const Level& level = database.levels[std::size_t(w.level)];
    const int cell = 2 << w.level;
    const float metres = static_cast<float>(database.unit);
    ReadOut out{{w.width - 2 * kFade, w.height - 2 * kFade}, near_seams(seams(land))};
    parallel_for(out.heights.height(), 8, [&](int y) {
        for (int x = 0; x < out.heights.width(); ++x) {
            const int cx = x + kFade, cy = y + kFade;
            if (!out.faded(cx, cy)) {
                out.heights(x, y) =
                    height_at(level, w.level, spot_of(land.origins(cx, cy))) +
                    metres * float(land.offsets(cx, cy));
                continue;
            }
            float sum = 0.0f;
            for (int dy = -kFade; dy <= kFade; ++dy) {
                for (int dx = -kFade; dx <= kFade; ++dx) {
                    const std::size_t i = land.origins.index(cx + dx, cy + dy);
                    const Spot spot = spot_of(land.origins[i]);
                    const Step back = kTurns(spot.orientation, -dx * cell, -dy * cell);
                    sum += weights.of[dy + kFade][dx + kFade] *
                           (height_at(level, w.level, spot.moved(back)) +
                            metres * float(land.offsets[i]));
                }
            }
            out.heights(x, y) = sum;
        }
    });
    return out;
}

float lowest_around(const Field<float>& heights, int x, int y) {
    float lowest = std::numeric_limits<float>::max();
    for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
            if (u != x || v != y) lowest = std::min(lowest, heights(u, v));
    return lowest;
}

}  // namespace

Field<float> heights_of(const Database& database, const Synthesis& land) {
    const ReadOut out = read_out(database, land);
    Field<float> heights(land.window.width - 2 * kReadOut,
                         land.window.height - 2 * kReadOut);
    parallel_for(heights.height(), 16, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            heights(x, y) = out.heights(x + 1, y + 1);
            if (out.faded(x + kReadOut, y + kReadOut))
                heights(x, y) =
                    std::max(heights(x, y), lowest_around(out.heights, x + 1, y + 1));
        }
    });
    return heights;
}

}  // namespace cydonia::texture
