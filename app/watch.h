#pragma once

#include "app/request.h"

namespace cydonia {

// Draws the scene's preview again whenever its file or one that it names is saved, until
// the user interrupts; <output>/watch.html shows it and reloads by itself. A scene that
// is wrong is said, there and on the terminal, and waited for.
void watch(const Request& request);

}  // namespace cydonia
