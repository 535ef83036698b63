// SPDX-License-Identifier: MIT
// How benchmarks time: processor time of the thread, and medians of ratios of works that take
// turns.
#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

namespace lanescope::benchmarks {

inline constexpr int kRounds = 21;

/// Processor time of this thread: other processes on a shared machine do not count.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class F>
double seconds(F&& work) {
  const double start = thread_seconds();
  work();
  return thread_seconds() - start;
}

inline double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Median of time(a) / time(b) over rounds in which they take turns.
template <class A, class B>
double ratio(A&& a, B&& b) {
  std::vector<double> ratios;
  for (int round = 0; round < kRounds; ++round) {
    const double one = seconds(a);
    ratios.push_back(one / seconds(b));
  }
  return median(ratios);
}

/// Median time over rounds.
template <class F>
double median_seconds(F&& work) {
  std::vector<double> times;
  for (int round = 0; round < kRounds; ++round) times.push_back(seconds(work));
  return median(times);
}

}  // namespace lanescope::benchmarks
