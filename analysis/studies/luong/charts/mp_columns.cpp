// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/charts/mp_columns.h"

#include <algorithm>

#include "analysis/html/spec.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {

std::vector<DataColumn> mp_columns(std::vector<DataColumn> others) {
  std::vector<DataColumn> columns{
      {"kernel", "Kernel", ""}, {"micropolygon", "Micropolygons", ""}, {"lanes", "W", ""}};
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

nlohmann::ordered_json choice_of_mp(const Report& report) {
  std::vector<std::string> plurals;
  for (const Series& series : series_of(report))
    if (const std::string shown = plural(series.facet);
        std::find(plurals.begin(), plurals.end(), shown) == plurals.end())
      plurals.push_back(shown);
  return choice("pick_mp", "Micropolygons", plurals, plurals.front());
}

}  // namespace lanescope::luong
