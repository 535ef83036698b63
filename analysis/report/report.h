// SPDX-License-Identifier: MIT
// The report of an experiment: what was run, how, and every count as an integer. Tables and
// pictures are functions of it. Ratios are kept as numerator and denominator; see
// analysis/report/figures.h.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "analysis/report/lane_groups.h"

namespace lanescope {

/// Version of the JSON form; a reader refuses all others.
inline constexpr int kReportVersion = 3;
inline constexpr std::string_view kReportSchema = "lanescope-report";

/// Counts of one instruction within a stage, as InstructionCounts has them.
struct InstructionRecord {
  std::string mnemonic;
  std::uint64_t issued = 0;
  std::uint64_t active = 0;
  std::uint64_t overhead_issued = 0;
  std::uint64_t overhead_active = 0;

  /// Adds counts of another instruction; the mnemonic stays.
  InstructionRecord& operator+=(const InstructionRecord& other);
};

/// What one memory instruction touched within a stage, over the executions that were observed.
struct MemoryRecord {
  std::string mnemonic;
  std::uint64_t issued = 0;  ///< Executions observed.
  std::uint64_t active = 0;  ///< Lanes on in them.
  std::uint64_t lines = 0;   ///< Distinct lines of 64 bytes, summed over executions.
  /// [W + 1 or more] executions that touched k lines; more if an execution touched more.
  std::vector<std::uint64_t> lines_histogram;
  /// Lanes that stored to an element that an earlier lane of the same execution stored to.
  std::uint64_t conflicts = 0;

  /// Adds counts of other executions; the mnemonic stays.
  MemoryRecord& operator+=(const MemoryRecord& other);
};

/// How the lanes of one instruction fell into groups within a stage, over the executions that were
/// observed.
struct LaneGroupRecord {
  std::string mnemonic;
  std::uint64_t issued = 0;  ///< Executions observed.
  LaneGroups groups{};       ///< Summed over executions.

  /// Adds counts of other executions; the mnemonic stays.
  LaneGroupRecord& operator+=(const LaneGroupRecord& other);
};

struct StageRecord {
  std::string name;
  std::vector<InstructionRecord> instructions;  ///< By mnemonic.
  std::vector<std::uint64_t> lane_active;       ///< [W] instructions issued with lane i on.
  std::vector<std::uint64_t> histogram;         ///< [W + 1] instructions issued with k lanes on.
  std::vector<MemoryRecord> memory;             ///< By mnemonic; see Observation.
  /// By mnemonic; empty if no piece was observed, and in reports of earlier programs.
  std::vector<LaneGroupRecord> lane_groups{};

  /// Sum over the instructions; without a mnemonic.
  InstructionRecord total() const;
  /// Sum over the memory instructions; without a mnemonic.
  MemoryRecord memory_total() const;
};

/// A figure that was counted beside instructions and lanes.
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

/// A list of figures that the kernel counted: a histogram, or a course over time.
struct SeriesRecord {
  std::string name;
  std::string meaning;
  std::string index;  ///< What the place in the list is.
  std::string unit;   ///< Of the values.
  std::vector<std::uint64_t> values;
};

/// A line of a kernel's source.
struct SourcePlace {
  std::string file;  ///< From the root of the sources: `kernels/<kind>/<name>.h`.
  std::uint32_t line = 0;

  auto operator<=>(const SourcePlace&) const = default;
};

/// What was issued at one line of a kernel's source within one stage and one block, over the pieces
/// of work observed.
struct SourceLineRecord {
  SourcePlace place;
  std::string stage;
  std::uint64_t issued = 0;
  std::uint64_t active = 0;    ///< Lanes charged.
  std::uint64_t overhead = 0;  ///< Those of `issued` that the kernel marks as overhead.
  /// Where the block was opened: for whom a line that blocks share was issued. None if the report
  /// does not say.
  std::optional<SourcePlace> block{};
};

/// What the pieces of work came from.
struct SourceRecord {
  std::uint64_t hash = 0;  ///< Of all pieces; equal for equal work.
  std::uint64_t pieces = 0;
  /// Those that memory and source lines were observed in (Configuration::observe_every).
  std::uint64_t pieces_observed = 0;
  std::vector<CounterRecord> counters;
};

/// What the kernel wrote.
struct OutputRecord {
  std::uint64_t hash = 0;  ///< Equal for equal content.
  std::vector<CounterRecord> counters;

  /// The value of that counter, if it is counted.
  std::optional<std::uint64_t> counter(std::string_view name) const;
};

/// What instructions are divided by, as Element has it.
struct ElementRecord {
  std::string counter;  ///< Name of one of the run's counters.
  std::string name;
  std::string abbreviation;
};

/// One run of one kernel at one width on one scene.
struct RunRecord {
  Configuration configuration;
  std::string workload;  ///< The kind of work.
  SourceRecord source;
  ElementRecord element;
  // What the kernel counts; empty if the mode counts nothing.
  std::vector<StageRecord> stages;
  std::vector<CounterRecord> counters;
  std::vector<MetricRecord> metrics;
  std::vector<SeriesRecord> series;
  std::vector<SourceLineRecord> source_lines;  ///< By file, line, stage and block.

  std::uint64_t results_hash = 0;  ///< Equal for equal sets of results, whatever their order.
  OutputRecord output;

  /// The stage of that name, or null.
  const StageRecord* stage(std::string_view name) const;
  /// The value of that counter, if the kernel counts it.
  std::optional<std::uint64_t> counter(std::string_view name) const;
  /// The counter `element.counter`.
  std::optional<std::uint64_t> elements() const { return counter(element.counter); }
  /// The list of that name, or null.
  const SeriesRecord* find_series(std::string_view name) const;
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
  std::vector<double> kernel_ms;        ///< [runs] time within the kernel, summed over threads.
  double source_ms = 0.0;               ///< Making the work, summed over threads.
  double observation_ms = 0.0;          ///< Observing memory and source lines, summed over threads.
  std::uint64_t peak_memory_bytes = 0;  ///< Largest resident set of the process.
};

struct Report {
  std::string program_version;
  std::string commit;  ///< Of the program's sources; empty if not known.
  /// The command that makes the same report; options that cannot change it are left out.
  std::string command;
  std::vector<InstructionEntry> instructions;  ///< Those issued in some run, by mnemonic.
  std::vector<RunRecord> runs;
  Timing timing;

  /// The time within the kernel of a run; none if the report is without times, as one may be that
  /// was not read from a file.
  std::optional<double> kernel_ms(std::size_t run) const;
};

/// Adds the names of the parameters that runs of a report have and `names` lacks, in their order.
void add_parameter_names(const Report& report, std::vector<std::string>& names);

/// A report and what messages call it: its file.
struct NamedReport {
  std::string name;
  Report report;
};

}  // namespace lanescope
