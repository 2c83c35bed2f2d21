#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/texture/constraints/guidance.h"
#include "synth/texture/constraints/window.h"
#include "synth/texture/database/database.h"

namespace cydonia::texture {

// S of section 4: where a cell's land comes from. A position in half cells of level 0
// from the exemplar's north-west corner; `x` also holds the exemplar and its orientation.
struct Origin {
    std::uint32_t x = 0;  // exemplar << 24 | orientation << 21 | x
    std::uint32_t y = 0;

    int exemplar() const { return static_cast<int>(x >> 24); }
    int orientation() const { return static_cast<int>(x >> 21 & 7u); }
    bool operator==(const Origin&) const = default;
};

// S and V of the cells of a window.
struct Synthesis {
    Window window;
    Field<Origin> origins;
    Field<std::int32_t> offsets;  // V, in Database::unit
};

// Land that should stay (section 5.3), given for each window and pass as one more
// candidate. The pass after the last is the result of lift().
struct PinnedRegion {
    Field<float> weights;  // W: 0: exactly this land; 1: none; empty: none anywhere
    Field<Origin> origins;
    Field<std::int32_t> offsets;
};

// Functions that steer a synthesis; each may be empty.
struct Guidance {
    std::function<Field<Pull>(const Window&)> pulls;
    std::function<Field<TypeSet>(const Window&)> types;
    std::function<PinnedRegion(const Window&, int pass)> pinned;
};

// The result of each correction pass, by level and pass. Where there are points and
// curves, the result of lift() follows.
using Recording = std::vector<std::vector<Synthesis>>;

struct Controls {
    std::uint64_t seed = 0;
    double jitter = 0.2;
    double kappa = 2.0;
    double stiffness = 0.5, pull = 0.5;  // s and lambda of eq. 8
    int orientations = 1;
    int finest = 0;  // level at which the synthesis stops
};

// The cells of a window of level controls.finest. A cell is the same in every window that
// contains it. If `record` is not null, it receives the result of every pass.
Synthesis synthesised(const Database& database, const Controls& controls,
                      const Guidance& guidance, const Window& window, Recording* record,
                      Progress& progress);

// Heights of a synthesis in metres, without its outermost kReadOut cells. Inside a patch
// they are the exemplar's; across seams patches fade into one another, and the pits that
// this makes are removed.
inline constexpr int kReadOut = 3;
Field<float> heights_of(const Database& database, const Synthesis& synthesis);

}  // namespace cydonia::texture
