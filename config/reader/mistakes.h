#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "config/reader/value.h"

namespace cydonia::config {

// What is wrong with one value; thrown by units, caught where the value's place is known.
struct Wrong {
    std::string message;
};

struct Mistake {
    Position at;
    std::string path;  // "terrain.stage[0].strokes"; empty for the whole file
    std::string message;
};

// Where mistakes come from, by origin: the scene file as the user wrote it, then every
// --set.
struct Origins {
    std::string file;
    std::vector<std::string> overrides;
};

// One line each, the file's first, in the order in which they stand there; the first 50.
std::string listed(std::vector<Mistake> mistakes, const Origins& origins);

// "; did you mean 'azimuth'?" where one of the names is near, else "; known: a, b".
std::string suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace cydonia::config
