#pragma once

#include <filesystem>

#include "app/console.h"
#include "app/request.h"
#include "field/error.h"

namespace cydonia {

// Renders every scene.toml in the folders of `scenes` (empty: those that ship), one after
// another, with the options of `each`. Writes a contact sheet and a page to out/gallery.
// A scene that fails does not stop the others; failure() names them at the end. Throws
// bad_request if there is no scene.
void make_gallery(const std::filesystem::path& scenes, const Request& each,
                  Console& console);

}  // namespace cydonia
