#include "app/threads.h"

#include <OpenImageIO/imageio.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace cydonia {

void with_threads(int threads, const std::function<void()>& work) {
    if (threads == 0) return work();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    // OpenImageIO and OpenEXR read and write files with thread pools of their own.
    OIIO::attribute("threads", threads);
    OIIO::attribute("exr_threads", threads);
    tbb::task_arena arena(threads);
    arena.execute(work);
}

int thread_count() { return tbb::this_task_arena::max_concurrency(); }

}  // namespace cydonia
