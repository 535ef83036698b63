// SPDX-License-Identifier: MIT
// What only a page of several settings has: figures over the values of the parameters that vary.
#pragma once

#include <vector>

#include "analysis/html/section.h"
#include "analysis/html/settings.h"

namespace lanescope {

/// Which setting needs the fewest instructions for each element, for each kernel, facet and W: a
/// table. Without rows for a single setting.
Markup cheapest_settings(const std::vector<Setting>& settings);

/// Instructions for each element, and utilization, over the values of one parameter.
std::vector<SectionBlock> over_parameter(const std::vector<Setting>& settings,
                                         const SettingAxis& axis);

}  // namespace lanescope
