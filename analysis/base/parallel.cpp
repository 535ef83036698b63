// SPDX-License-Identifier: MIT
#include "analysis/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// Hands out items, and keeps the first exception.
class Queue {
 public:
  explicit Queue(int count) : count_(count) {}

  void run(const std::function<void(int)>& work, const std::function<void(int)>& progress) {
    try {
      for (int item = next_++; item < count_ && !stopped_; item = next_++) {
        work(item);
        const int done = ++done_;
        if (progress) progress(done);
      }
    } catch (...) {
      stopped_ = true;
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const int count_;
  std::atomic<int> next_{0};
  std::atomic<int> done_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void parallel_for(int threads, int count, const std::function<void(int, int)>& work,
                  const std::function<void(int)>& progress) {
  LANESCOPE_CHECK(threads > 0, "{} threads", threads);
  Queue queue(count);
  std::vector<std::jthread> helpers;
  for (int worker = 1; worker < std::min(threads, count); ++worker)
    helpers.emplace_back(
        [&queue, &work, worker] { queue.run([&](int item) { work(worker, item); }, nullptr); });
  queue.run([&](int item) { work(0, item); }, progress);
  helpers.clear();  // Joins them.
  queue.rethrow();
}

}  // namespace lanescope
