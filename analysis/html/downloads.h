// SPDX-License-Identifier: MIT
// The reports themselves, within the page.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// Links that save each report as JSON, and all of them as tidy CSV: runs, and stages. What would
/// make the page too large is named with the command that writes it instead.
std::string downloads_html(const std::vector<NamedReport>& sources);

}  // namespace lanescope
