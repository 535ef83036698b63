// SPDX-License-Identifier: MIT
// The page of `lanescope report`: one HTML file that needs nothing but a browser.
#pragma once

#include <string>
#include <vector>

#include "analysis/html/groups.h"

namespace lanescope {

/// The page of all runs of the reports: what was run, the frames, and every section for each
/// setting. `pictures` is the directory with the frames. Throws InputError if two reports have the
/// same run, there is no run at all, or a picture is no PNG file.
std::string report_page(const std::vector<NamedReport>& sources, const std::string& pictures);

}  // namespace lanescope
