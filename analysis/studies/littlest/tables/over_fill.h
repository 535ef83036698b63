// SPDX-License-Identifier: MIT
// Tables over how full the world is.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "analysis/studies/littlest/figures.h"

namespace lanescope::littlest {

/// Rows are programs at each width, columns the scattered worlds of the view's report.
/// `figure` gets a view of one of these.
TableData over_fill(const ReportView& view, std::string title, const Unit& unit,
                    const std::function<std::optional<double>(
                        const ReportView& scene, const Series& series, int width)>& figure);

}  // namespace lanescope::littlest
