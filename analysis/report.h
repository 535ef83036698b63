// SPDX-License-Identifier: MIT
// The report of an experiment: what was run, how, and every count as an integer. Tables and
// pictures are functions of it. Ratios are kept as numerator and denominator; see
// analysis/figures.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/configuration.h"
#include "workloads/tessellator.h"

namespace lanescope {

/// Version of the JSON form; a reader refuses a newer one.
inline constexpr int kReportVersion = 1;
inline constexpr std::string_view kReportSchema = "lanescope-report";

/// Counts of one instruction within a stage, as InstructionCounts has them.
struct InstructionRecord {
  std::string mnemonic;
  std::uint64_t issued = 0;
  std::uint64_t active = 0;
  std::uint64_t overhead_issued = 0;
  std::uint64_t overhead_active = 0;
};

struct StageRecord {
  std::string name;
  std::vector<InstructionRecord> instructions;  ///< By mnemonic.
  std::vector<std::uint64_t> lane_active;       ///< [W] instructions issued with lane i on.
  std::vector<std::uint64_t> histogram;         ///< [W + 1] instructions issued with k lanes on.

  /// Sum over the instructions; without a mnemonic.
  InstructionRecord total() const;
};

/// A figure that the kernel counted beside instructions and lanes.
struct CounterRecord {
  std::string name;
  std::string meaning;
  std::string unit;
  std::uint64_t value = 0;
};

/// A ratio of two counters, by name.
struct MetricRecord {
  std::string name;
  std::string meaning;
  std::string numerator;
  std::string denominator;
};

/// One run of one kernel at one width on one scene.
struct RunRecord {
  Configuration configuration;
  bool thesis_like = false;      ///< The scene is one of those that the thesis's tables average.
  std::uint64_t scene_hash = 0;  ///< Of all packets; equal for equal geometry.
  TessellationCounts tessellation;
  std::vector<StageRecord> stages;  ///< Empty if the mode counts nothing.
  std::vector<CounterRecord> counters;
  std::vector<MetricRecord> metrics;
  std::uint64_t hits_hash = 0;
  std::uint64_t frame_hash = 0;
  std::uint64_t samples_covered = 0;

  /// The stage of that name, or null.
  const StageRecord* stage(std::string_view name) const;
  /// The value of that counter, if the kernel counts it.
  std::optional<std::uint64_t> counter(std::string_view name) const;
};

/// An instruction as the dictionary of the report explains it.
struct InstructionEntry {
  std::string mnemonic;
  std::string meaning;
  std::string instruction_class;
  std::string charge;
};

/// What depends on the clock and the host; comparisons of reports leave it out.
struct Timing {
  double wall_ms = 0.0;
  int threads = 1;
  std::string host;
  std::string compiler;
  std::vector<double> kernel_ms;  ///< [runs] time within the kernel, summed over threads.
};

struct Report {
  std::string program_version;
  /// The command that makes the same report; options that cannot change it are left out.
  std::string command;
  std::vector<InstructionEntry> instructions;  ///< Those issued in some run, by mnemonic.
  std::vector<RunRecord> runs;
  Timing timing;
};

}  // namespace lanescope
