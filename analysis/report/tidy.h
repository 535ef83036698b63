// SPDX-License-Identifier: MIT
// Reports as tidy data: one row for each thing counted, one column for each parameter and each
// figure, for notebooks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "analysis/report/report_json.h"

namespace lanescope {

/// What a row is about.
enum class TidyRows {
  kInstructions,  ///< One instruction within one stage of a run.
  kStages,        ///< One stage of a run.
  kRuns,          ///< One run.
};

inline constexpr std::array<Choice<TidyRows>, 3> kTidyRows{
    {{"instructions", TidyRows::kInstructions},
     {"stages", TidyRows::kStages},
     {"runs", TidyRows::kRuns}}};

struct TidyTable {
  std::vector<std::string> columns;            ///< Names, in snake_case.
  std::vector<std::vector<std::string>> rows;  ///< As long as `columns`; empty where undefined.
};

/// The rows of all reports, in their order. Parameters, counters and metrics of runs become
/// columns: the union over all runs, with empty fields where a run has none. A counter or metric
/// whose name its row has already is `source_`, `counter_`, `output_` or `metric_` and its name.
/// Numbers have a point; switches are TRUE or FALSE; hashes begin with `x`, so that no reader of
/// CSV takes them for numbers.
TidyTable tidy(const std::vector<NamedReport>& reports, TidyRows rows);

/// The table as CSV with a header.
std::string tidy_csv(const TidyTable& table);

}  // namespace lanescope
