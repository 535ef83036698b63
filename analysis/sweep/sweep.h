// SPDX-License-Identifier: MIT
// Runs the cells of a sweep and keeps each one's report as soon as it is there.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/experiment/experiment_groups.h"
#include "analysis/sweep/sweep_directory.h"

namespace lanescope {

/// Cells in the shard `index` of `count`, from 1. Shards are disjoint and together all cells.
/// Cells of one source are dealt out together as long as there are enough such groups for all
/// shards. Requires 1 <= index <= count.
std::vector<Configuration> shard_of(const std::vector<Configuration>& cells, int index, int count);

/// Where a sweep is. Cells that an earlier start has finished are not counted.
struct SweepProgress {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t left = 0;
  std::size_t elsewhere = 0;  ///< Of those left, the ones that other processes were running.
  double fraction = 0.0;      ///< Of the expected work of this start, from 0 to 1.
};

struct SweepOptions {
  int threads = 1;
  /// Cells of one source run as a group, which it feeds piece by piece. Nothing of the work is
  /// stored, so that sharing costs only the memory of the group's outputs. What is lost when the
  /// process is killed is the group that runs; a limit of members makes that less, and with a limit
  /// of 1 nothing is shared.
  GroupLimits group_limits;
  /// What the reports of the cells name as their command.
  std::string command;
  std::function<void(const SweepProgress&)> progress;
  /// Hears of each scene as it is opened.
  OpeningListener opening;
};

/// What one start of a sweep did.
struct SweepSummary {
  std::size_t cells = 0;    ///< All that were asked for.
  std::size_t skipped = 0;  ///< Finished before.
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t elsewhere = 0;  ///< Finished by other processes meanwhile.
  std::size_t groups = 0;     ///< Sources that were opened for the cells done.
  double wall_ms = 0.0;
  int threads = 1;
  double kernel_ms = 0.0;  ///< This and the times below are summed over threads.
  double observation_ms = 0.0;
  double source_ms = 0.0;           ///< Making the work.
  double source_unshared_ms = 0.0;  ///< Had the work of each cell been made by itself.
  std::uint64_t peak_memory_bytes = 0;
  std::map<std::string, std::size_t> failures;  ///< How many cells failed, by what went wrong.

  double work_ms() const { return kernel_ms + observation_ms + source_ms; }
  double work_unshared_ms() const { return work_ms() - source_ms + source_unshared_ms; }
};

/// Runs the cells whose reports are not in the directory yet, but for those that other processes
/// run; waits for these in the end, and runs what they have left undone. A cell that cannot be run
/// is kept as a failure and does not stop the others. Requires that the directory is open. Throws
/// InputError if results cannot be written.
SweepSummary run_sweep(const std::vector<Configuration>& cells, const SweepDirectory& directory,
                       const SweepOptions& options);

/// A figure in proportion to the time that a cell takes, to weigh cells against each other.
double expected_work(const Configuration& cell);

/// How long the cells that are left will take, and how that is known.
struct SweepEstimate {
  double seconds = 0.0;
  bool from_finished_cells = false;  ///< Otherwise from a brief run of a part of one group.
};

/// Estimates from the times of the cells that are done, or, if there are none, from a brief run of
/// `left`, of which nothing is kept. None if that fails.
std::optional<SweepEstimate> estimate_sweep(const std::vector<Report>& done,
                                            const std::vector<Configuration>& left,
                                            const SweepOptions& options);

}  // namespace lanescope
