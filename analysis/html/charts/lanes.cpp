// SPDX-License-Identifier: MIT
#include "analysis/html/charts/lane_chart.h"

namespace lanescope {
namespace {

const std::vector<std::uint64_t>& lane_active(const StageRecord& stage) {
  return stage.lane_active;
}

std::vector<SectionBlock> build(const ReportView& view) {
  return lane_chart(view, {"Share of the instructions of each stage that were issued with the lane "
                           "on, in one scene.",
                           "Lane", lane_active});
}

}  // namespace

extern const Section s_lanes{
    "lanes", "Activity of each lane",
    "Where work is dealt out evenly, every lane is active as often as the others.", build};

}  // namespace lanescope
