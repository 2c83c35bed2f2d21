#pragma once

#include <functional>

namespace cydonia {

// Runs `work` on this many threads, even if the machine has fewer cores; 0: one for each
// core.
void with_threads(int threads, const std::function<void()>& work);

// How many threads the work may use, for programs that it starts.
int thread_count();

}  // namespace cydonia
