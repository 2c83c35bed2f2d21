#pragma once

#include <filesystem>

#include "app/request.h"
#include "field/progress.h"

namespace cydonia {

// Heights from a file, whose shadows are compared with an image.
struct HeightCheck {
    std::filesystem::path height;
    std::filesystem::path target;
    std::filesystem::path window;  // shadows count where it is white; empty: everywhere
    double azimuth = 0.0, elevation = 0.0;  // of the sun, degrees
};

// Casts the shadows and compares them; writes pictures to <output>/shadow. Uses output,
// threads, force and dry_run of the request. Throws as make() does.
void check_height(const HeightCheck& asked, const Request& request, Progress& progress);

}  // namespace cydonia
