#pragma once

#include <array>

namespace cydonia::texture {

// R, one of the eight ways to lay an exemplar down: (`orientation` & 3) quarter turns,
// then a mirroring in x where (`orientation` & 4). A step on the terrain is the step
// R(step) on the exemplar.
struct Step {
    int x, y;
    bool operator==(const Step&) const = default;
};

constexpr Step turned(int orientation, Step s) {
    for (int i = 0; i < (orientation & 3); ++i) s = {-s.y, s.x};
    if (orientation & 4) s.x = -s.x;
    return s;
}

// `first` followed by `second`: turned(composed(a, b), s) == turned(b, turned(a, s)).
constexpr int composed(int first, int second) {
    for (int o = 0; o < 8; ++o) {
        bool same = true;
        for (Step s : {Step{1, 0}, Step{0, 1}})
            same &= turned(o, s) == turned(second, turned(first, s));
        if (same) return o;
    }
    return 0;
}

}  // namespace cydonia::texture
