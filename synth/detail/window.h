#pragma once

namespace cydonia::detail {

// Where a land lies in a larger one, of which it is a part: its north-west corner and the
// whole's size, in samples of its level.
struct Window {
    int x = 0, y = 0;
    int width = 0, height = 0;
};

}  // namespace cydonia::detail
