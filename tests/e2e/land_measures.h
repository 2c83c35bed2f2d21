#pragma once

#include <cstdint>
#include <vector>

#include "field/source.h"
#include "field/terrain.h"

namespace cydonia::test {

// A local maximum and how far one must come down from it to reach higher land.
struct Peak {
    int x = 0, y = 0;
    float height = 0.0f, prominence = 0.0f;  // metres
    int parent_x = 0, parent_y = 0;  // the higher peak that lies beyond; itself for the
                                     // highest
};

// Those of at least this prominence, highest first; one is as prominent as it is high
// above the lowest land.
std::vector<Peak> peaks_of(const Field<float>& heights, float prominence);
// The same of hollows: `prominence` is their depth below the lowest way out.
std::vector<Peak> pits_of(const Field<float>& heights, float depth);

// Degrees, by central differences; 0 on the border.
Field<float> slopes_of(const Terrain& terrain);

// What a picture draws on a grid of this shape.
Field<std::uint8_t> drawn(const Source& picture, const Field<float>& shape);

// Metres to the nearest cell that is set, within 8%.
Field<float> distances_to(const Field<std::uint8_t>& cells, double spacing);

// Of the values where the distance is above the first and up to the second.
std::vector<float> values_between(const Field<float>& values,
                                  const Field<float>& distances, double least,
                                  double most);

// These throw std::invalid_argument when there is no value.
double mean_of(const std::vector<float>& values);
double deviation_of(const std::vector<float>& values);
// The value below which this share of them lies; 0.5 is the median.
double quantile_of(std::vector<float> values, double share);

}  // namespace cydonia::test
