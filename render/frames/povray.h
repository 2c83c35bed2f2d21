#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "field/progress.h"

namespace cydonia::render {

// The path of `povray`. Throws failure(), naming the package to install.
std::filesystem::path povray_program();

// Runs POV-Ray in `folder` on `name`.ini, without a shell, and writes
// `folder`/`name`.exr, linear Rec.709. Reports the share of the time that has passed
// (trace_progress.h). Throws failure() with POV-Ray's own error text. After `time_limit`,
// or when the user interrupts, POV-Ray is killed and its unfinished files are removed.
void run_povray(const std::filesystem::path& folder, const std::string& name, int threads,
                std::chrono::seconds time_limit, Progress& progress);

}  // namespace cydonia::render
