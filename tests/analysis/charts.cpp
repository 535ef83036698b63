// SPDX-License-Identifier: MIT
#include "tests/analysis/charts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lanescope::testing {

Chart chart_of(const std::vector<const Section*>& sections, const ReportView& view,
               std::string_view section_id, std::string_view chart_id) {
  for (const Section* section : sections) {
    if (section->id != section_id) continue;
    for (SectionBlock& block : section->build(view))
      if (Chart* chart = std::get_if<Chart>(&block); chart && chart->id == chart_id) return *chart;
  }
  ADD_FAILURE() << section_id << ' ' << chart_id;
  return {};
}

nlohmann::ordered_json last_of(const Chart& chart, const std::vector<nlohmann::ordered_json>& begin,
                               std::size_t from_end) {
  for (const auto& row : chart.rows.rows())
    if (std::equal(begin.begin(), begin.end(), row.begin())) return row[row.size() - 1 - from_end];
  ADD_FAILURE() << "no row " << nlohmann::ordered_json(begin).dump();
  return {};
}

}  // namespace lanescope::testing
