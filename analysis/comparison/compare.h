// SPDX-License-Identifier: MIT
// What differs between the runs of two reports. Times are not compared, nor are source lines, which
// move when the sources are edited.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/report/report_json.h"
#include "analysis/tables/table.h"

namespace lanescope {

struct CompareOptions {
  /// The relative difference up to which figures may differ. Hashes may differ if it is above 0.
  double tolerance = 0.0;
  /// Parameters that runs may differ in and still be compared; with `kernel`, also those that not
  /// all runs have.
  std::set<std::string> ignored;
};

/// A figure that is not the same in two runs.
struct Change {
  /// Or `All stages`, `Source` or `Output`; empty if it is of the run otherwise.
  std::string stage;
  std::string figure;  ///< `issued`, `tests`, `output_hash`.
  const Unit* unit;    ///< Of numbers.
  bool is_detail;      ///< Of one instruction, or of lists of lanes; its stage's sums say more.
  nlohmann::ordered_json before;     ///< A number or a hash; null if the figure is not there.
  nlohmann::ordered_json after;      ///< Likewise.
  std::optional<double> difference;  ///< After minus before; of lists, the sum of all differences.
  std::optional<double> relative;    ///< In `before`; none if that is 0.
  bool within_tolerance;
};

/// A run that is in both reports and not the same.
struct RunChanges {
  std::string run;  ///< Its parameters, in words.
  nlohmann::ordered_json parameters;
  std::vector<Change> changes;  ///< Details last; the largest first.
};

/// A run that is in one report only.
struct LoneRun {
  std::string run;
  nlohmann::ordered_json parameters;
};

struct Comparison {
  std::size_t compared = 0;      ///< Runs in both.
  std::vector<RunChanges> runs;  ///< Those that differ, in the order of the first report.
  std::vector<LoneRun> only_before;
  std::vector<LoneRun> only_after;

  /// Whether each run is in both reports and the same up to the tolerance.
  bool same() const;
};

/// Compares runs of equal parameters. Throws InputError if a report has two runs that differ in
/// nothing but what `options` ignores, or if that is no parameter of a run in either.
Comparison compare(const NamedReport& before, const NamedReport& after,
                   const CompareOptions& options);

/// A comparison as a document.
struct ComparisonDocument {
  const NamedReport& before;
  const NamedReport& after;
  const CompareOptions& options;
  const Comparison& comparison;
  std::size_t limit;  ///< Changes shown of each run; 0 for all. The JSON form has all.

  /// For a terminal, or GitHub's Markdown.
  std::string text(bool markdown) const;
  nlohmann::ordered_json json() const;
};

}  // namespace lanescope
