// SPDX-License-Identifier: MIT
// Work shared among threads.
#pragma once

#include <functional>

namespace lanescope {

/// Calls work(worker, item) once for each item from 0 to count - 1, on `threads` threads that take
/// items as they get free; `worker` is from 0 to threads - 1, and worker 0 is the caller's thread.
/// If a call throws, no further items are taken and the first exception is rethrown here. Between
/// its items, the caller's thread calls progress(items finished), if there is such a function.
/// Requires threads > 0.
void parallel_for(int threads, int count, const std::function<void(int worker, int item)>& work,
                  const std::function<void(int done)>& progress = nullptr);

}  // namespace lanescope
