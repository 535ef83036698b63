// SPDX-License-Identifier: MIT
// Memory instructions of stages, and what they touched in the pieces of work that were observed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/tables/report_view.h"

namespace lanescope {

/// A memory instruction of a stage.
struct MemoryPlace {
  std::string stage;
  std::string mnemonic;

  /// `Test: gather`
  std::string name() const { return stage + ": " + mnemonic; }
};

/// Those of some runs, in the order of the stages, then of mnemonics.
std::vector<MemoryPlace> memory_places(const std::vector<const RunRecord*>& runs,
                                       const std::vector<std::string>& stages);

/// What a run has of it, or null.
const MemoryRecord* find_memory(const RunRecord& run, const MemoryPlace& place);

/// Quotients of two of its counts, as means over the scenes of a view.
std::optional<double> mean_lines(const ReportView& view, const Series& series, int width,
                                 const MemoryPlace& place);
std::optional<double> mean_lanes_on(const ReportView& view, const Series& series, int width,
                                    const MemoryPlace& place);
std::optional<double> mean_conflicts(const ReportView& view, const Series& series, int width,
                                     const MemoryPlace& place);
/// The share of the executions that touched that many lines.
std::optional<double> mean_share_of_lines(const ReportView& view, const Series& series, int width,
                                          const MemoryPlace& place, std::size_t lines);

}  // namespace lanescope
