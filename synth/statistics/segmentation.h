#pragma once

#include "synth/statistics/similarity.h"
#include "synth/statistics/windows.h"

namespace cydonia::statistics {

inline constexpr int kNoType = -1;

// The windows of an example that represent its type: at most `most` of them, spread over
// the example.
std::vector<Analysis> spread_windows(const Field<Analysis>& windows, int most = 49);

// Divides land of several types into them (Saunders 2006, section VII.5). Each block
// takes the type that its window is most similar to; `library` consists of windows. Then
// neighbours vote, each with the weight of its similarity to the type. kNoType where a
// block has no window.
Field<int> block_types(const Library& library, const Field<Analysis>& windows);

// The types of blocks as a field of width x height samples, with the corners of borders
// cut.
Field<int> sample_types(const Field<int>& blocks, int width, int height);

// The largest rectangle that holds only `type`, x0 <= x < x1 and y0 <= y < y1; empty
// where there is none.
struct Rectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    long area() const { return long(x1 - x0) * (y1 - y0); }
};
Rectangle largest_rectangle(const Field<int>& types, int type);

}  // namespace cydonia::statistics
