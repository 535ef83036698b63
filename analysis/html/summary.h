// SPDX-License-Identifier: MIT
// What was run: a section at the end of the page.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// Commands and versions, scenes with hashes and what was made of them, the parameters that are the
/// same in all runs and those that vary, and a note about time and host.
std::string summary_html(const std::vector<NamedReport>& sources);

}  // namespace lanescope
