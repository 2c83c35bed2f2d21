#pragma once

#include "synth/statistics/similarity.h"
#include "synth/statistics/windows.h"

namespace cydonia::genetic {

inline constexpr int kNoType = -1;

// The windows of an example that stand for its type where windows are compared: spread
// over it, at most so many.
std::vector<Analysis> spread_windows(const Field<Analysis>& windows, int most = 49);

// Saunders 2006, section VII.5: land of several types cut into them. Each block takes the
// type that its window is most like (`library`: of windows), then what most of its
// neighbours are, each as loudly as it is like that type. kNoType where a block has no
// window.
Field<int> block_types(const Library& library, const Field<Analysis>& windows);

// The blocks' types at each sample, of width x height; borders cut the corners of blocks.
Field<int> sample_types(const Field<int>& blocks, int width, int height);

// The largest rectangle of one type alone, x0 <= x < x1; empty where there is none.
struct Rectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    long area() const { return long(x1 - x0) * (y1 - y0); }
};
Rectangle largest_rectangle(const Field<int>& types, int type);

}  // namespace cydonia::genetic
