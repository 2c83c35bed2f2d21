#pragma once

#include <string>

#include "config/reader/scene.h"

namespace cydonia {

// What a scene asks for, in a few lines.
std::string description(const config::SceneSpec& spec);

// What a file holds: a scene, heights, an image or a manifest. Throws bad_request for
// anything else.
std::string description(const std::filesystem::path& file);

}  // namespace cydonia
