// SPDX-License-Identifier: MIT
// Charts of the lanes of a stage: one scene, facet and W at a time, picked beside the chart; a
// panel for each kernel and stage.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/html/section.h"

namespace lanescope {

/// What such a chart draws for each stage: a list of counts over a place (a lane, or a number of
/// lanes), shown as shares of the stage's instructions.
struct LaneChart {
  std::string caption;
  std::string place_title;  ///< What the place in the list is.
  const std::vector<std::uint64_t>& (*counts)(const StageRecord& stage);
};

std::vector<SectionBlock> lane_chart(const ReportView& view, const LaneChart& chart);

}  // namespace lanescope
