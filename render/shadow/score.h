#pragma once

#include <cstdint>
#include <optional>

#include "field/field.h"

namespace cydonia::render {

// How well a cast shadow matches its target. A target has a value a cell; a cast has
// rays x rays samples for each of its cells, and each cell of the target stands for all
// of them. Masks are 1 in shadow, 0 lit; only cells whose `window` is not 0 count, all
// where it is empty. Masks of other shapes throw bad_request.

// 1 is perfect; where nothing is wanted and nothing is cast, all three are 1.
struct ShadowScore {
    double iou = 0.0, precision = 0.0, recall = 0.0;
};
ShadowScore score(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target,
                  const Field<std::uint8_t>& window = {});

// F-score of the outlines: the harmonic mean of the shares of each that lie within
// `tolerance` cells of the other.
double outline_score(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target,
                     const Field<std::uint8_t>& window = {}, double tolerance = 1.0);

// Recall of the target's parts thinner than `cells`: those that an opening by a disc of
// that diameter takes away. None where there are none.
std::optional<double> thin_recall(const Field<std::uint8_t>& cast,
                                  const Field<std::uint8_t>& target,
                                  const Field<std::uint8_t>& window = {}, int cells = 4);

// Pearson's of two masks of one shape; 0 where either is all one value.
double correlation(const Field<std::uint8_t>& a, const Field<std::uint8_t>& b,
                   const Field<std::uint8_t>& window = {});

// Samples a cell side of `cast` on the cells of `target`.
int rays_of(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target);
// Every cell as rays x rays samples.
Field<std::uint8_t> repeated(const Field<std::uint8_t>& cells, int rays);

}  // namespace cydonia::render
