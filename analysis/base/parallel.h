// SPDX-License-Identifier: MIT
// Work shared among threads.
#pragma once

#include <functional>

namespace lanescope {

/// How many threads, up to `wanted`, can run now; the caller's is one of them. Requires wanted > 0.
int startable_threads(int wanted);

/// Calls work(worker, item) once for each item from 0 to count - 1, on `threads` threads that take
/// items as they get free; `worker` is from 0 to threads - 1, and worker 0 is the caller's thread.
/// If a call throws, no further items are taken and the first exception is rethrown here. Between
/// its items, the caller's thread calls progress(items finished), if there is such a function.
/// Where the system does not start so many threads, those that there are do all items.
/// Requires threads > 0.
void parallel_for(int threads, int count, const std::function<void(int worker, int item)>& work,
                  const std::function<void(int done)>& progress = nullptr);

}  // namespace lanescope
