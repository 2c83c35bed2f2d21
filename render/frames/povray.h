#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "field/progress.h"

namespace cydonia::render {

// Where `povray` is, or a failure() that names the package to install.
std::filesystem::path povray_program();

// Runs POV-Ray in `folder` on `name`.ini without a shell; reports its progress; on
// failure throws its own error text. The result is `folder`/`name`.exr, linear Rec.709.
// Killed and cleaned up after `time_limit` or when the user interrupts.
void run_povray(const std::filesystem::path& folder, const std::string& name, int threads,
                std::chrono::seconds time_limit, Progress& progress);

}  // namespace cydonia::render
