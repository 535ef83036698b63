// SPDX-License-Identifier: MIT
// Where in a kernel's source instructions are issued, and how busy the lanes are there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/report/figures.h"
#include "analysis/report/report.h"
#include "analysis/tables/table.h"

namespace lanescope {

/// The lines of one kernel at one width and facet, summed over the scenes of a report.
struct Annotation {
  std::string kernel;
  int width = 0;
  std::string facet;  ///< As facet_of() has it.
  std::vector<std::string> scenes;
  std::string setting;                  ///< Of its runs, as shown_setting() has it.
  std::uint64_t pieces = 0;             ///< Of work.
  std::uint64_t pieces_observed = 0;    ///< What the sums are over.
  std::uint64_t issued = 0;             ///< At all lines.
  std::vector<SourceLineRecord> lines;  ///< Hottest first.

  /// `<kernel>, W = <width>, <facet>: <scenes>`.
  std::string title() const;
  Ratio share(const SourceLineRecord& line) const { return {line.issued, issued}; }
  Ratio utilization(const SourceLineRecord& line) const;
};

/// An annotation for each kernel, width and facet of the report whose lines were observed, in the
/// order of their first runs.
std::vector<Annotation> annotate(const Report& report);

/// The hottest `count` lines with their source and that of their blocks, as a table.
TableData hottest_lines(const Annotation& annotation, std::size_t count);

/// The sources that the lines are in, each line with its share of the instructions, its utilization
/// and the number issued in the margin, in all stages and blocks together.
std::string annotated_source(const Annotation& annotation);

}  // namespace lanescope
