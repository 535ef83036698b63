// SPDX-License-Identifier: MIT
#include "analysis/html/charts/utilization_chart.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {
namespace {

std::vector<SectionBlock> build(const ReportView& view) {
  return utilization_chart(view,
                           {kAllButSetup, "All but Setup", " All but Setup: as the thesis sums."});
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_utilization{
    "utilization", "Utilization over W",
    "The share of the lane slots of issued instructions in which a lane is active.", luong::build};

}  // namespace lanescope
