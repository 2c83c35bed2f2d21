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

// S, section 4: where a cell's land comes from. Half cells of level 0 from the exemplar's
// north-west corner; `x` also carries the exemplar and its orientation.
struct Place {
    std::uint32_t x = 0;  // exemplar << 24 | orientation << 21 | x
    std::uint32_t y = 0;

    int exemplar() const { return static_cast<int>(x >> 24); }
    int orientation() const { return static_cast<int>(x >> 21 & 7u); }
    bool operator==(const Place&) const = default;
};

// S and V of a window at its level.
struct Synthesis {
    Window window;
    Field<Place> places;
    Field<std::int32_t> offsets;  // V, in Database::unit
};

// Land that is to stay (section 5.3), for a window and a pass: as one more candidate. The
// pass after the last is what points and curves then lift.
struct Kept {
    Field<float> weights;  // W: 0 exactly this land, 1 none of it; empty: none anywhere
    Field<Place> places;
    Field<std::int32_t> offsets;
};

// What steers a synthesis; each may be missing.
struct Guidance {
    std::function<Field<Pull>(const Window&)> pulls;
    std::function<Field<TypeSet>(const Window&)> types;
    std::function<Kept(const Window&, int pass)> kept;
};

// What each correction pass left behind, by level and pass; where there are points and
// curves, then what they made of it.
using Recording = std::vector<std::vector<Synthesis>>;

struct Controls {
    std::uint64_t seed = 0;
    double jitter = 0.2;
    double kappa = 2.0;
    double stiffness = 0.5, pull = 0.5;  // s and lambda of eq. 8
    int orientations = 1;
    int finest = 0;  // the level to stop at
};

// Level controls.finest of the plane inside `window`. The same cells for every window
// that holds them. `record` receives what every pass left, where it is not null.
Synthesis synthesised(const Database& database, const Controls& controls,
                      const Guidance& guidance, const Window& window, Recording* record,
                      Progress& progress);

// Heights of a synthesis, metres, without its outermost kReadOut cells: where neighbours
// come from one place, that place's land; across seams a cross-fade, without the pits
// that it makes.
inline constexpr int kReadOut = 3;
Field<float> heights_of(const Database& database, const Synthesis& synthesis);

}  // namespace cydonia::texture
