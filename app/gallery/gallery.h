#pragma once

#include <filesystem>

#include "app/console.h"
#include "app/request.h"
#include "field/error.h"

namespace cydonia {

// Renders every scene.toml in the folders of `scenes` (empty: those that ship), each as
// `each` says but for its scene and output folder, one after another, and lays them out
// in out/gallery: a contact sheet and a page. A scene that fails does not stop the
// others; failure() names them at the end. Throws bad_request where there is no scene.
void make_gallery(const std::filesystem::path& scenes, const Request& each,
                  Console& console);

}  // namespace cydonia
