// SPDX-License-Identifier: MIT
#include <map>

#include "analysis/tables/means.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

/// Instructions for each element by class, of all stages.
std::map<std::string, double> by_class(const ReportView& view, const Series& series, int width,
                                       const InstructionName& class_of) {
  std::map<std::string, double> sums;
  for (const std::string& stage : stages_of(view, series))
    for (const auto& [name, value] : mean_mix(view, series, width, stage, class_of))
      sums[name] += value;
  return sums;
}

std::vector<Row> rows(const ReportView& view, const Series& series) {
  const InstructionName class_of = class_in(view.report());
  std::map<int, std::map<std::string, double>> mixes;
  std::map<std::string, double> names;
  for (const int width : view.widths(series)) {
    mixes[width] = by_class(view, series, width, class_of);
    for (const auto& [name, value] : mixes[width]) names[name] += value;
  }
  std::vector<Row> rows;
  for (const auto& [name, _] : names)
    rows.push_back(row_over(view, series, name, [&](int width) {
      const auto found = mixes[width].find(name);
      const double value = found == mixes[width].end() ? 0.0 : found->second;
      return Cell{Figure{value, {}, &kInstructions},
                  Figure{quotient(value, mean_instructions(view, series, width)), {}, &kShare},
                  {}};
    }));
  return rows;
}

TableData build(const ReportView& view) {
  return table_over_widths(view,
                           "Instructions for each element, of all stages, by class (share of them)",
                           "Class", rows);
}

}  // namespace

extern const Table t_mix{"mix", "instructions for each element, by class", build};

}  // namespace lanescope
