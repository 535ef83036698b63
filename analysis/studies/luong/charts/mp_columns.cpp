// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/charts/mp_columns.h"

namespace lanescope::luong {

std::vector<DataColumn> mp_columns(std::vector<DataColumn> others) {
  std::vector<DataColumn> columns{
      {"kernel", "Kernel", ""}, {"micropolygon", "Micropolygons", ""}, {"lanes", "W", ""}};
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

Pick pick_of_mp() { return {"micropolygon", nullptr}; }

}  // namespace lanescope::luong
