#pragma once

#include <filesystem>

#include "app/request.h"
#include "field/progress.h"

namespace cydonia {

// Heights that are not ours, held against an image.
struct HeightCheck {
    std::filesystem::path height;
    std::filesystem::path target;
    std::filesystem::path window;           // white: shadows count; empty: everywhere
    double azimuth = 0.0, elevation = 0.0;  // of the sun, degrees
};

// Casts and compares; pictures go to <output>/shadow. Of the request it takes output,
// threads, force and dry_run. Throws as make() does.
void check_height(const HeightCheck& asked, const Request& request, Progress& progress);

}  // namespace cydonia
