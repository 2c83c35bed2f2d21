#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace cydonia {

// Runs `work` on `threads` threads, also where that is more than the machine has; 0: as
// many as it has.
template <class Work>
void with_threads(int threads, const Work& work) {
    if (threads == 0) return work();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute(work);
}

// How many threads a program that we start may use.
inline int thread_count() { return tbb::this_task_arena::max_concurrency(); }

}  // namespace cydonia
