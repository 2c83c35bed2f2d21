#pragma once

#include <filesystem>

#include "app/console.h"

namespace cydonia {

// What the command line asks about a terrain library.
struct LibraryRequest {
    std::filesystem::path library;
    std::filesystem::path land;    // an elevation model; empty: the library itself
    std::filesystem::path output;  // where analyses are kept; empty: out/<library's name>
    int threads = 0;
    bool quiet = false;
};

// These print tables. They keep the analyses, so that the next call takes a moment.

// How well each type's examples agree, and whether each is most like its own type.
void analyse_library(const LibraryRequest& request, Console& console);
// How similar a land is to each type, quantity by quantity.
void compare_with_library(const LibraryRequest& request, Console& console);
// Which type a land fits best, and how adding it to that type would change the agreement
// of the type's examples. Writes a map of the types in it into the output folder.
void classify_by_library(const LibraryRequest& request, Console& console);

}  // namespace cydonia
