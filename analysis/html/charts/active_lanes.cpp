// SPDX-License-Identifier: MIT
#include "analysis/html/charts/lane_chart.h"

namespace lanescope {
namespace {

const std::vector<std::uint64_t>& histogram(const StageRecord& stage) { return stage.histogram; }

std::vector<SectionBlock> build(const ReportView& view) {
  return lane_chart(view, {"Share of the instructions of each stage that were issued with exactly "
                           "so many lanes on, in one scene.",
                           "Lanes on", histogram});
}

}  // namespace

extern const Section s_active_lanes{
    "active-lanes", "How many lanes are on",
    "A stage that is well packed issues nearly all of its instructions with all lanes on.", build};

}  // namespace lanescope
