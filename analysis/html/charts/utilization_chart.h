// SPDX-License-Identifier: MIT
// Utilization of each stage over W, and of some together.
#pragma once

#include <string>
#include <vector>

#include "analysis/html/section.h"
#include "analysis/report/figures.h"

namespace lanescope {

/// The dashed line: the stages that are summed, and what they are called.
struct Together {
  Stages stages;
  std::string name;  ///< Differs from those of stages; without quotation marks.
  std::string note;  ///< A sentence for the caption, after a space; or empty.
};

std::vector<SectionBlock> utilization_chart(const ReportView& view, const Together& together);

}  // namespace lanescope
