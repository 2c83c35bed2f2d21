#pragma once

#include <filesystem>

#include "app/console.h"

namespace cydonia {

// What the command line asks of a terrain library.
struct LibraryRequest {
    std::filesystem::path library;
    std::filesystem::path land;    // an elevation model; empty: the library itself
    std::filesystem::path output;  // where analyses are kept; empty: out/<library's name>
    int threads = 0;
    bool quiet = false;
};

// Print tables, and keep analyses so that the next time takes a moment.
// How well each type's examples agree, and whether each is most like its own type.
void analyse_library(const LibraryRequest& request, Console& console);
// How like each type a land is, quantity by quantity.
void compare_with_library(const LibraryRequest& request, Console& console);
// Which type it fits best, and what adding it to that would do to the agreement; which
// types it is made of, on a map in the output folder.
void classify_by_library(const LibraryRequest& request, Console& console);

}  // namespace cydonia
