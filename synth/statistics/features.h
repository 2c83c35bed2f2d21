#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "field/parallel.h"

namespace cydonia::genetic {

// An edge, ridge, valley or peak, found over all scales at once (Saunders 2006, section
// III.3.2.2).
struct Feature {
    float scale = 0.0f;     // metres: how far it is spread out, a standard deviation
    float length = 0.0f;    // metres
    float strength = 0.0f;  // the detector's response, the mean along it
    std::vector<std::uint32_t> samples;  // where it runs: indices of the field
};

// Of samples on a feature their place among the scales and the response there; of others
// -1.
struct Found {
    Found(int width, int height) : place(width, height, -1.0f), response(width, height) {}
    Field<float> place, response;
};

// Steps 2 and 3 for scale `k`, by its responses and those of its neighbours, times
// `sign`: where the response is largest over scales, larger than what other scales gave,
// above `faintest`, and `is_crest(x, y)` holds. Scales come in any order.
template <class IsCrest>
void find_largest(const Field<float>& finer, const Field<float>& own,
                  const Field<float>& coarser, float sign, int k, float faintest,
                  const IsCrest& is_crest, Found& found) {
    parallel_for(own.height(), 8, [&](int y) {
        // First those that may be, without a branch: few are.
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
            // Between two scales by a parabola through three.
            const float bend = a - 2.0f * b + c;
            found.place[i] = b > faintest && is_crest(x, y)
                                 ? float(k) + (bend < 0.0f ? 0.5f * (a - c) / bend : 0.0f)
                                 : -1.0f;
        }
    });
}

// Found samples that hang together, in the plane and from scale to scale; of too few
// samples they are noise. Strengths as `found.response` has them.
std::vector<Feature> linked(const Found& found, double spacing);

}  // namespace cydonia::genetic
