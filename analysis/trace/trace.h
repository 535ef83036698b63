// SPDX-License-Identifier: MIT
// Every instruction of a window of a scene, shown to sinks: a kernel runs in tracing mode, and what
// it does outside the window is not looked at.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "analysis/configuration/configuration.h"
#include "simulator/observer.h"

namespace lanescope {

/// What is traced. Batches are what the kernel takes at a time, up to W elements of work; they are
/// counted from 0 in the order of the source, over the whole scene or, if there is a region, over
/// the elements that meet it. A batch begins where the kernel takes it, and ends where the kernel
/// takes the next or has finished the piece of work.
struct TraceWindow {
  static constexpr std::uint64_t kToTheEnd = std::numeric_limits<std::uint64_t>::max();

  std::optional<Region> region;
  std::uint64_t first_batch = 0;
  std::uint64_t end_batch = kToTheEnd;  ///< The first that is not traced.

  bool holds(std::uint64_t batch) const { return first_batch <= batch && batch < end_batch; }
};

/// Takes traces, of one kernel after another.
class TraceSink {
 public:
  virtual ~TraceSink() = default;
  virtual void begin(const Configuration& configuration, const Kernel& kernel) = 0;
  virtual void batch(std::uint64_t number) = 0;
  virtual void issued(const IssueEvent& event) = 0;
  virtual void end() = 0;
};

/// Runs the configuration's kernel on the window and shows it to the sinks. `progress` is called
/// with the finished share of the work, from 0 to 1, `opening` hears how the scene is opened.
/// Throws InputError for what the configuration names and does not exist, a kernel that issues no
/// instructions, a region if its kind of work has none, and a window that does not lie in the
/// picture and the scene. Requires that the window holds a batch.
void trace(const Configuration& configuration, const TraceWindow& window,
           std::span<TraceSink* const> sinks, const std::function<void(double)>& progress,
           const OpeningListener& opening = {});

}  // namespace lanescope
