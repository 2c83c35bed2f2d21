#pragma once

#include <cstdint>
#include <optional>

#include "field/field.h"

namespace cydonia::render {

// How well a cast shadow matches its target. A target has one value a cell, a cast has
// rays x rays samples a cell, which are all compared with that value. Masks are 1 in
// shadow and 0 lit. Only cells whose `window` is not 0 count; an empty window means all
// cells. Throws bad_request for masks of other shapes.

// 1 is perfect. When nothing is wanted and nothing is cast all three are 1.
struct ShadowScore {
    double iou = 0.0, precision = 0.0, recall = 0.0;
};
ShadowScore score(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target,
                  const Field<std::uint8_t>& window = {});

// F-score of the outlines: the harmonic mean of the shares of each outline that lie
// within `tolerance` cells of the other.
double outline_score(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target,
                     const Field<std::uint8_t>& window = {}, double tolerance = 1.0);

// Recall of the target's parts thinner than `cells`, which are those that a morphological
// opening by a disc of that diameter removes. Nothing when there are none.
std::optional<double> thin_recall(const Field<std::uint8_t>& cast,
                                  const Field<std::uint8_t>& target,
                                  const Field<std::uint8_t>& window = {}, int cells = 4);

// Pearson's correlation of two masks of one shape; 0 when either is constant.
double correlation(const Field<std::uint8_t>& a, const Field<std::uint8_t>& b,
                   const Field<std::uint8_t>& window = {});

// Samples a cell side of `cast` on the cells of `target`.
int rays_of(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target);
// A mask with every cell repeated as rays x rays samples.
Field<std::uint8_t> repeated(const Field<std::uint8_t>& cells, int rays);

}  // namespace cydonia::render
