#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "field/parallel.h"

namespace cydonia::statistics {

// An edge, ridge, valley or peak, found over all scales at once (Saunders 2006, section
// III.3.2.2).
struct Feature {
    float scale = 0.0f;     // metres: a standard deviation across the feature
    float length = 0.0f;    // metres
    float strength = 0.0f;  // mean response of the detector along it
    std::vector<std::uint32_t> samples;  // indices of its samples in the field
};

// For samples on a feature its position among the scales, and the detector's response
// there; `place` is -1 elsewhere.
struct Found {
    Found(int width, int height) : place(width, height, -1.0f), response(width, height) {}
    Field<float> place, response;
};

// Steps 2 and 3 for scale `k`, from its responses and those of the two scales beside it,
// all multiplied by `sign`. A sample is found where the response is a maximum over
// scales, larger than those of scales seen before and above `faintest`, and where
// `is_crest(x, y)` holds. Scales may come in any order.
template <class IsCrest>
void find_largest(const Field<float>& finer, const Field<float>& own,
                  const Field<float>& coarser, float sign, int k, float faintest,
                  const IsCrest& is_crest, Found& found) {
    parallel_for(own.height(), 8, [&](int y) {
        // First finds the few candidates, without a branch.
        std::vector<std::uint8_t> may(std::size_t(own.width()));
        const float *fine = finer.row(y).data(), *here = own.row(y).data(),
                    *coarse = coarser.row(y).data(), *best = found.response.row(y).data();
        for (std::size_t x = 0; x < may.size(); ++x) {
            const float b = sign * here[x];
            may[x] = std::uint8_t((b > sign * fine[x]) & (b >= sign * coarse[x]) &
                                  (b > best[x]));
        }
        for (int x = 0; x < own.width(); ++x) {
            if (!may[std::size_t(x)]) continue;
            const std::size_t i = own.index(x, y);
            const float a = sign * finer[i], b = sign * own[i], c = sign * coarser[i];
            found.response[i] = b;
            // The position between scales is that of the top of a parabola through three.
            const float bend = a - 2.0f * b + c;
            found.place[i] = b > faintest && is_crest(x, y)
                                 ? float(k) + (bend < 0.0f ? 0.5f * (a - c) / bend : 0.0f)
                                 : -1.0f;
        }
    });
}

// Features made of found samples that are connected in the plane and similar in scale.
// Features of too few samples are noise and left out. (Whether two samples are connected
// depends on both of their scales, which OpenCV's connectedComponents cannot express.)
std::vector<Feature> linked(const Found& found, double spacing);

}  // namespace cydonia::statistics
