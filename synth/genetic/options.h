#pragma once

#include <array>
#include <string>
#include <vector>

#include "field/source.h"

namespace cydonia::genetic {

// Real land of one type, or a part of it: shares from its south-west corner, west, south,
// east and north.
struct Example {
    Source source;
    std::array<double, 4> window{0.0, 0.0, 1.0, 1.0};
};

// A type of land by examples (Saunders 2006, section IV.2.1).
struct TypeOptions {
    std::string name;
    std::vector<Example> examples;
};

// A terrain library: kinds of land as people think of them.
struct LibraryOptions {
    std::string name;
    std::vector<TypeOptions> types;
    // Levels of detail, metres from sample to sample, coarse to fine.
    std::vector<double> levels = {810.0, 270.0, 90.0, 30.0, 10.0};
};

}  // namespace cydonia::genetic
