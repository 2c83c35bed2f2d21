#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "config/reader/value.h"

namespace cydonia::config {

// What is wrong with one value. Units throw it, and Table, which knows where the value
// stands, catches it.
struct Wrong {
    std::string message;
};

struct Mistake {
    Position at;
    std::string path;  // "terrain.stage[0].strokes"; empty for the whole file
    std::string message;
};

// What mistakes can originate from: the scene file as the user named it, then every
// --set.
struct Origins {
    std::string file;
    std::vector<std::string> overrides;
};

// The mistakes as lines in the order in which they stand, those of the file first; at
// most 50.
std::string listed(std::vector<Mistake> mistakes, const Origins& origins);

// The end of a message about an unknown name: "; did you mean 'azimuth'?" when a known
// name is similar, otherwise "; known: a, b".
std::string suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace cydonia::config
