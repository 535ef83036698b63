// SPDX-License-Identifier: MIT
// The page of `lanescope report`: one HTML file that needs nothing but a browser.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/html/section.h"
#include "analysis/report/report.h"

namespace lanescope {

/// What a page shows of a setting.
struct PagePlan {
  /// The first of them is the answer, which the page begins with.
  std::vector<const Section*> sections;
  /// The scenes whose figures are averaged; all of the setting's if it has none of these.
  std::vector<std::string> scenes;
};

/// Plans the page of a setting.
using PlanOf = std::function<PagePlan(const Report& setting)>;

/// The page of all runs of the reports: the answer, the frames, the sections that are planned for
/// its settings, one of which is shown at a time, and what was run. `pictures` is the directory
/// with the frames. Throws InputError if two reports have the same run, there is no run at all, or
/// a picture is no PNG file.
std::string report_page(const std::vector<NamedReport>& sources, const std::string& pictures,
                        const PlanOf& plan_of);

}  // namespace lanescope
