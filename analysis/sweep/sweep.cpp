// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <new>
#include <thread>

#include "analysis/base/build_info.h"
#include "analysis/base/memory.h"
#include "analysis/experiment/experiment.h"
#include "analysis/experiment/stopwatch.h"
#include "analysis/report/merge.h"
#include "analysis/sweep/cell_claims.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Indices = std::vector<std::size_t>;

/// Groups by source alone, so that shards do not depend on how much memory a machine has.
constexpr GroupLimits kNoLimits{std::numeric_limits<std::uint64_t>::max()};

std::vector<Configuration> select(const std::vector<Configuration>& cells, const Indices& indices) {
  std::vector<Configuration> selected;
  for (const std::size_t index : indices) selected.push_back(cells[index]);
  return selected;
}

double expected_work(const std::vector<Configuration>& cells) {
  double sum = 0.0;
  for (const Configuration& cell : cells) sum += lanescope::expected_work(cell);
  return sum;
}

/// Between looks at what other processes do.
constexpr std::chrono::milliseconds kPatience{300};

/// One start of a sweep.
class Sweep {
 public:
  Sweep(const std::vector<Configuration>& cells, const SweepDirectory& directory,
        const SweepOptions& options)
      : directory_(directory), options_(options) {
    for (const Configuration& cell : cells)
      if (!directory.find(cell)) left_.push_back(cell);
    summary_.cells = cells.size();
    summary_.skipped = cells.size() - left_.size();
    summary_.threads = options.threads;
    to_do_ = left_.size();
    work_ = expected_work(left_);
  }

  SweepSummary run() {
    Stopwatch watch;
    while (!left_.empty()) {
      const std::vector<Configuration> claimed_elsewhere = run_what_is_free();
      // Their processes finish them, or end and so leave them to others.
      if (claimed_elsewhere.size() == left_.size()) std::this_thread::sleep_for(kPatience);
      left_ = claimed_elsewhere;
      elsewhere_ = left_.size();
      tell(0.0);
    }
    summary_.wall_ms = watch.ms();
    summary_.peak_memory_bytes = peak_memory_bytes();
    return summary_;
  }

 private:
  /// Runs the cells that no other process has claimed. Returns those that one has.
  std::vector<Configuration> run_what_is_free() {
    std::vector<Configuration> claimed_elsewhere;
    for (const Indices& indices : group_by_source(left_, options_.group_limits)) {
      std::vector<Configuration> group;
      std::vector<std::string> ids;
      for (const Configuration& cell : select(left_, indices)) {
        const std::string id = cell_id(cell);
        if (!claims_.take(id)) {
          claimed_elsewhere.push_back(cell);
          continue;
        }
        ids.push_back(id);
        if (directory_.find(cell))
          skip(cell);
        else
          group.push_back(cell);
      }
      if (!group.empty()) run_group(group);
      for (const std::string& id : ids) claims_.give_back(id);
    }
    return claimed_elsewhere;
  }

  /// Another process has finished the cell.
  void skip(const Configuration& cell) {
    ++summary_.elsewhere;
    work_done_ += expected_work(cell);
  }

  /// Runs cells together. If that fails, each one by itself, so that only the guilty one fails.
  void run_group(const std::vector<Configuration>& group) {
    std::string error;
    if (const auto report = try_run(group, error)) {
      keep(group, *report);
    } else if (group.size() == 1) {
      directory_.keep_failure(group.front(), error);
      ++summary_.failed;
      ++summary_.failures[error];
    } else {
      for (const Configuration& cell : group) run_group({cell});
      return;
    }
    work_done_ += expected_work(group);
    tell(0.0);
  }

  std::optional<Report> try_run(const std::vector<Configuration>& group, std::string& error) {
    ExperimentOptions options;
    options.threads = options_.threads;
    options.group_limits = options_.group_limits;
    options.outputs = &outputs_;
    options.opening = options_.opening;
    options.progress = [&](double fraction) { tell(fraction * expected_work(group)); };
    try {
      return run_experiment(group, options);
    } catch (const std::bad_alloc&) {
      error = kOutOfMemory;
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    return std::nullopt;
  }

  void keep(const std::vector<Configuration>& group, Report report) {
    report.command = options_.command;
    for (std::size_t i = 0; i < group.size(); ++i) {
      directory_.keep(group[i], single_run(report, i));
      ++summary_.done;
      summary_.kernel_ms += report.timing.kernel_ms[i];
    }
    ++summary_.groups;
    summary_.observation_ms += report.timing.observation_ms;
    summary_.source_ms += report.timing.source_ms;
    summary_.source_unshared_ms += report.timing.source_ms * static_cast<double>(group.size()) /
                                   source_passes(group, options_.threads);
  }

  /// `work` is finished in the group that runs.
  void tell(double work) const {
    if (!options_.progress) return;
    const std::size_t finished = summary_.done + summary_.failed + summary_.elsewhere;
    options_.progress({summary_.done, summary_.failed, to_do_ - finished, elsewhere_,
                       std::min(1.0, (work_done_ + work) / work_)});
  }

  const SweepDirectory& directory_;
  const SweepOptions& options_;
  const CellClaims claims_{directory_.path()};
  std::vector<Configuration> left_;
  std::size_t to_do_ = 0;      ///< Cells that were left at the start.
  std::size_t elsewhere_ = 0;  ///< Of those left, the ones that other processes were running.
  SweepSummary summary_;
  OutputPool outputs_;
  double work_ = 0.0;
  double work_done_ = 0.0;
};

/// The time that something took on one thread, and its expected work.
struct Measurement {
  double ms = 0.0;
  double work = 0.0;
};

Measurement of_finished(const std::vector<Report>& done) {
  Measurement sum;
  for (const Report& report : done) {
    sum.ms += report.timing.wall_ms * report.timing.threads;
    for (const RunRecord& run : report.runs) sum.work += expected_work(run.configuration);
  }
  return sum;
}

/// Of one group of the cells, extrapolated.
Measurement of_brief_run(const std::vector<Configuration>& left, const SweepOptions& options) {
  for (const Indices& indices : group_by_source(left, options.group_limits)) {
    const std::vector<Configuration> group = select(left, indices);
    try {
      return {estimated_thread_ms(group, options.group_limits), expected_work(group)};
    } catch (const std::exception&) {
      // What cannot be run takes no time; another group may tell more.
    }
  }
  return {};
}

}  // namespace

std::vector<Configuration> shard_of(const std::vector<Configuration>& cells, int index, int count) {
  LANESCOPE_CHECK(index >= 1 && index <= count, "shard {} of {}", index, count);
  const auto shards = static_cast<std::size_t>(count);
  const std::vector<Indices> groups = group_by_source(cells, kNoLimits);
  // Too few groups are cut into as many parts each as give every shard one.
  const std::size_t parts = (shards + groups.size() - 1) / groups.size();
  Indices mine;
  std::size_t next = 0;
  for (const Indices& group : groups)
    for (std::size_t part = 0; part < parts; ++part, ++next) {
      if (next % shards != static_cast<std::size_t>(index) - 1) continue;
      const auto cut = [&](std::size_t at) {
        return group.begin() + static_cast<std::ptrdiff_t>(group.size() * at / parts);
      };
      mine.insert(mine.end(), cut(part), cut(part + 1));
    }
  std::sort(mine.begin(), mine.end());
  return select(cells, mine);
}

SweepSummary run_sweep(const std::vector<Configuration>& cells, const SweepDirectory& directory,
                       const SweepOptions& options) {
  return Sweep(cells, directory, options).run();
}

double expected_work(const Configuration& cell) {
  return workload_of(cell).expected_work(cell.arguments);
}

std::optional<SweepEstimate> estimate_sweep(const std::vector<Report>& done,
                                            const std::vector<Configuration>& left,
                                            const SweepOptions& options) {
  const Measurement measured = done.empty() ? of_brief_run(left, options) : of_finished(done);
  if (measured.work == 0.0) return std::nullopt;
  const double ms = measured.ms / measured.work * expected_work(left) / options.threads;
  return SweepEstimate{ms / 1000.0, !done.empty()};
}

}  // namespace lanescope
