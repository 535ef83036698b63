// SPDX-License-Identifier: MIT
// Runs configurations and reports what they counted. One tessellation feeds all configurations that
// see the same micropolygons, packet by packet, because it costs more than a kernel does.
#pragma once

#include <functional>
#include <vector>

#include "analysis/experiment/experiment_groups.h"
#include "analysis/experiment/frame_pool.h"
#include "analysis/pictures/image.h"
#include "analysis/report/report.h"
#include "kernels/micropolygons/frame.h"

namespace lanescope {

struct FinishedFrame {
  const Configuration& configuration;
  const Frame& frame;
  Colour background;  ///< The scene's, for samples that nothing covers.
};

struct ExperimentOptions {
  int threads = 1;
  GroupLimits group_limits;
  /// Frames of earlier experiments to use again; if null, there are none.
  FramePool* frames = nullptr;
  /// Called with the finished share of the work, from 0 to 1, on the caller's thread.
  std::function<void(double fraction)> progress;
  /// Called with the finished frame of each configuration, on the caller's thread. Frames are not
  /// kept: a group of configurations has its frames only while it runs.
  std::function<void(const FinishedFrame&)> on_frame;
};

/// Runs configurations, in groups that share a tessellation, on several threads. The report has one
/// run for each, in their order, and is the same at any number of threads except for `timing`; its
/// `command` is left to the caller. Memory is that of the frames of one group.
/// Throws InputError for what a configuration names and does not exist or is out of range; an
/// exception within a worker is rethrown here. Requires options.threads > 0.
Report run_experiment(const std::vector<Configuration>& configurations,
                      const ExperimentOptions& options);

}  // namespace lanescope
