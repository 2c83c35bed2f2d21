#pragma once

#include <string>

#include "config/reader/scene.h"

namespace cydonia {

// A summary of a scene in a few lines.
std::string description(const config::SceneSpec& spec);

// A summary of a file, which is a scene, heights, an image or a manifest. Throws
// bad_request for any other.
std::string description(const std::filesystem::path& file);

}  // namespace cydonia
