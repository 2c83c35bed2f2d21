#pragma once

#include "app/request.h"

namespace cydonia {

// Draws the scene's preview again whenever its file, or a file that it names, is saved,
// until the user interrupts. <output>/watch.html shows the preview and reloads by itself.
// Mistakes in the scene are shown there and on the terminal; watching goes on.
void watch(const Request& request);

}  // namespace cydonia
