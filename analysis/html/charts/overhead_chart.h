// SPDX-License-Identifier: MIT
// The share of each stage's instructions that kernels mark as overhead.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/html/section.h"

namespace lanescope {

/// What a paper has for a stage, of no width in particular.
struct PaperOverhead {
  std::string title;  ///< Of its column in the table.
  std::string note;   ///< A sentence for the caption.
  std::function<std::optional<double>(const Series& series, const std::string& stage)> figure;
};

/// Strokes show the paper's figures, if there are any.
std::vector<SectionBlock> overhead_chart(const ReportView& view,
                                         const std::optional<PaperOverhead>& paper = std::nullopt);

}  // namespace lanescope
