#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <optional>

namespace cydonia {

// While it lives, parallel work uses at most `threads` threads; 0: all that there are.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads) {
        if (threads > 0) {
            limit_.emplace(tbb::global_control::max_allowed_parallelism, threads);
        }
    }

  private:
    std::optional<tbb::global_control> limit_;
};

// How many threads a program that we start may use.
inline int thread_count() {
    const std::size_t limit =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return std::min(static_cast<int>(limit), tbb::this_task_arena::max_concurrency());
}

}  // namespace cydonia
