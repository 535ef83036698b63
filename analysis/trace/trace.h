// SPDX-License-Identifier: MIT
// Every instruction of a window of a scene, shown to sinks: a kernel runs in tracing mode on the
// packets that reach into the window, and on no others.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "analysis/configuration/configuration.h"
#include "analysis/trace/region_filter.h"
#include "simulator/observer.h"

namespace lanescope {

/// What is traced. Batches of W micropolygons are counted from 0 in the order of the tessellator,
/// over the whole scene or, if there is a region, over the micropolygons that meet it. A batch
/// begins where the kernel takes it, and ends where the kernel takes the next or has drained.
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
/// with the finished share of the work, from 0 to 1.
/// Throws InputError for what the configuration names and does not exist, a kernel that issues no
/// instructions, and a window that does not lie in the frame and the scene. Requires that the
/// window holds a batch.
void trace(const Configuration& configuration, const TraceWindow& window,
           std::span<TraceSink* const> sinks, const std::function<void(double)>& progress);

}  // namespace lanescope
