// SPDX-License-Identifier: MIT
#include "analysis/html/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/configuration/configuration.h"
#include "analysis/html/markup.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// How many of its parameters are not as they are by default.
int departures(const Setting& setting) {
  int count = 0;
  for (const auto& [name, value] : setting.group->setting.all()) {
    const Parameter* const parameter = find_parameter(name);
    count += !parameter || parameter->fallback != value;
  }
  return count;
}

}  // namespace

std::optional<double> number(const Value& value) {
  if (const auto* integer = std::get_if<std::uint64_t>(&value))
    return static_cast<double>(*integer);
  if (const auto* real = std::get_if<float>(&value)) return std::stod(value_text(*real));
  return std::nullopt;
}

bool is_numeric(const SettingAxis& axis) {
  return std::all_of(axis.values.begin(), axis.values.end(),
                     [](const Value& value) { return number(value).has_value(); });
}

std::string shown_value(const Setting& setting, const std::string& parameter) {
  const Arguments& values = setting.group->setting;
  return values.contains(parameter) ? value_text(values[parameter]) : "none";
}

std::vector<SettingAxis> axes_of(const std::vector<Setting>& settings) {
  std::vector<SettingAxis> axes;
  for (const Setting& setting : settings)
    for (const auto& [name, value] : setting.group->setting.all()) {
      auto axis = std::find_if(axes.begin(), axes.end(),
                               [&](const SettingAxis& other) { return other.parameter == name; });
      if (axis == axes.end()) axis = axes.insert(axis, {name, {}});
      if (std::find(axis->values.begin(), axis->values.end(), value) == axis->values.end())
        axis->values.push_back(value);
    }
  for (SettingAxis& axis : axes)
    if (is_numeric(axis))
      std::sort(axis.values.begin(), axis.values.end(),
                [](const Value& a, const Value& b) { return *number(a) < *number(b); });
  return axes;
}

std::size_t first_setting(const std::vector<Setting>& settings) {
  const auto least = std::min_element(
      settings.begin(), settings.end(),
      [](const Setting& a, const Setting& b) { return departures(a) < departures(b); });
  return static_cast<std::size_t>(least - settings.begin());
}

std::string setting_controls(const std::vector<Setting>& settings) {
  if (settings.size() < 2) return {};
  const std::size_t first = first_setting(settings);
  std::vector<Json> list(settings.size(), Json::object());
  std::string text = "<form id=\"setting\"><span>Setting, of all charts and tables below:</span>\n";
  for (const SettingAxis& axis : axes_of(settings)) {
    text += fmt::format("<label>{0} <select name=\"{0}\">", html_escaped(axis.parameter));
    std::vector<std::string> options;
    for (const Value& value : axis.values) options.push_back(value_text(value));
    for (std::size_t i = 0; i < settings.size(); ++i) {
      list[i][axis.parameter] = shown_value(settings[i], axis.parameter);
      if (list[i][axis.parameter] == "none" &&
          std::find(options.begin(), options.end(), "none") == options.end())
        options.push_back("none");
    }
    for (const std::string& option : options)
      text += fmt::format("<option{}>{}</option>",
                          list[first][axis.parameter] == option ? " selected" : "",
                          html_escaped(option));
    text += "</select></label>\n";
  }
  return text + fmt::format("<script type=\"application/json\">{}</script></form>\n",
                            script_json({{"first", first}, {"settings", list}}));
}

}  // namespace lanescope
