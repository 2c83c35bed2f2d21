#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace cydonia {

// Calls body(i) for every i in [0, count), in any order, on as many threads as the
// program was given. Each call must write only to places of its own, so that the result
// does not depend on the number of threads.
template <class Body>
void parallel_for(int count, int grain, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<int>(0, count, static_cast<std::size_t>(grain)),
                      [&](const tbb::blocked_range<int>& range) {
                          for (int i = range.begin(); i != range.end(); ++i) body(i);
                      });
}

template <class Body>
void parallel_for(int count, const Body& body) {
    parallel_for(count, 1, body);
}

}  // namespace cydonia
