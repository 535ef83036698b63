// SPDX-License-Identifier: MIT
// The settings of a page: the values of the parameters that a sweep varies beside kernel, width,
// scene and facet. The page shows one at a time; some sections are about all of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/html/groups.h"
#include "analysis/tables/report_view.h"

namespace lanescope {

/// A group of runs and the scenes of it that figures are averaged over.
struct Setting {
  const Group* group;
  ReportView view;
};

/// A parameter that settings differ in, and its values: numbers ascending, words as they occur.
struct SettingAxis {
  std::string parameter;
  std::vector<Value> values;
};

/// A value as a number; none for words.
std::optional<double> number(const Value& value);
bool is_numeric(const SettingAxis& axis);
/// The value of a setting as text; `none` if it is of another kind of work and lacks the parameter.
std::string shown_value(const Setting& setting, const std::string& parameter);

/// None for a single setting.
std::vector<SettingAxis> axes_of(const std::vector<Setting>& settings);

/// The setting that the page begins with: the one with the fewest parameters that are not as by
/// default, the first of several.
std::size_t first_setting(const std::vector<Setting>& settings);

/// The controls that pick a setting, for all charts at once, with the settings for page.js. Empty
/// for a single setting.
std::string setting_controls(const std::vector<Setting>& settings);

}  // namespace lanescope
