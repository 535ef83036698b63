// SPDX-License-Identifier: MIT
// Runs configurations and reports what they counted. One source feeds all configurations that see
// the same work, piece by piece, because making it can cost more than a kernel does.
#pragma once

#include <functional>
#include <vector>

#include "analysis/experiment/experiment_groups.h"
#include "analysis/experiment/output_pool.h"
#include "analysis/report/report.h"

namespace lanescope {

struct FinishedOutput {
  const Configuration& configuration;
  const Output& output;  ///< Of the type that the kernel opens.
};

struct ExperimentOptions {
  int threads = 1;
  GroupLimits group_limits;
  /// Outputs of earlier experiments to use again; if null, there are none.
  OutputPool* outputs = nullptr;
  /// Called with the finished share of the work, from 0 to 1, on the caller's thread.
  std::function<void(double fraction)> progress;
  /// Hears of each scene as it is opened, on the caller's thread.
  OpeningListener opening;
  /// Called with the finished output of each configuration, on the caller's thread. Outputs are not
  /// kept: a group of configurations has its outputs only while it runs.
  std::function<void(const FinishedOutput&)> on_output;
};

/// Runs configurations, in groups that share a source, on several threads. The report has one run
/// for each, in their order, and is the same at any number of threads except for `timing`; its
/// `command` is left to the caller. Memory is that of the outputs of one group.
/// Throws InputError for what a configuration names and does not exist or is out of range, and,
/// before anything is run, if there is not enough memory for the outputs; FailedCheck if the
/// results of runs of checked mode depend on their width; an exception within a worker is rethrown
/// here. Requires options.threads > 0.
Report run_experiment(const std::vector<Configuration>& configurations,
                      const ExperimentOptions& options);

/// How long the experiment would take one thread, in milliseconds, from a brief run of a few
/// segments of each group, of which nothing is kept. Throws as run_experiment does.
double estimated_thread_ms(const std::vector<Configuration>& configurations,
                           const GroupLimits& group_limits);

}  // namespace lanescope
