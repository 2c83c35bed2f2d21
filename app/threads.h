#pragma once

#include <functional>

namespace cydonia {

// Runs `work` on `threads` threads, also where that is more than the machine has; 0: as
// many as it has.
void with_threads(int threads, const std::function<void()>& work);

// How many threads a program that we start may use.
int thread_count();

}  // namespace cydonia
