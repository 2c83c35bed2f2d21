#pragma once

namespace cydonia::detail {

// Where a part of a land lies in the whole: its north-west corner, and the size of the
// whole, in samples of its level.
struct Window {
    int x = 0, y = 0;
    int width = 0, height = 0;
};

}  // namespace cydonia::detail
