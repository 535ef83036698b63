// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/tables/over_fill.h"

namespace lanescope::littlest {
namespace {

TableData build(const ReportView& view) {
  return over_fill(view, "Utilization of all stages, over how full the world is", kPercent,
                   [](const ReportView& scene, const Series& series, int width) {
                     return mean_utilization(scene, series, width);
                   });
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_fill_utilization{
    "fill_utilization", "utilization of each program, over how full the world is", littlest::build};

}  // namespace lanescope
