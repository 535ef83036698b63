// SPDX-License-Identifier: MIT
#include "analysis/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <mutex>
#include <system_error>
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

/// As many threads, up to that, as the system starts; each runs the work with its number, from 0.
template <class Work>
std::vector<std::jthread> start_threads(int count, const Work& work) {
  std::vector<std::jthread> threads;
  try {
    for (int i = 0; i < count; ++i) threads.emplace_back(work, i);
  } catch (const std::system_error&) {
    // The system has no more.
  }
  return threads;
}

}  // namespace

int startable_threads(int wanted) {
  std::latch all_tried(1);
  const auto helpers = start_threads(wanted - 1, [&](int) { all_tried.wait(); });
  all_tried.count_down();
  return static_cast<int>(helpers.size()) + 1;
}

void parallel_for(int threads, int count, const std::function<void(int, int)>& work,
                  const std::function<void(int)>& progress) {
  LANESCOPE_CHECK(threads > 0, "{} threads", threads);
  Queue queue(count);
  std::vector<std::jthread> helpers = start_threads(std::min(threads, count) - 1, [&](int helper) {
    queue.run([&](int item) { work(helper + 1, item); }, nullptr);
  });
  queue.run([&](int item) { work(0, item); }, progress);
  helpers.clear();  // Joins them.
  queue.rethrow();
}

}  // namespace lanescope
