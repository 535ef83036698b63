// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep_axis.h"

#include <algorithm>

#include "analysis/configuration/configuration_json.h"

namespace lanescope {
namespace {

void require_name(const JsonCursor& value, std::string_view kind,
                  const std::vector<std::string>& names, std::string_view otherwise = "") {
  const std::string name = value.string();
  if (std::find(names.begin(), names.end(), name) == names.end())
    value.fail(
        fmt::format("{}; use {}{}{}", kind, list_or(names), otherwise, did_you_mean(name, names)));
}

/// Whether a scene fits a kernel shows when there is a cell; here it must be one of some kind.
void require_scene(const JsonCursor& value) {
  std::vector<std::string> names;
  std::vector<std::string> endings;
  for (const Workload* workload : workloads()) {
    if (workload->is_file(value.string())) return;
    for (const SceneInfo& scene : workload->scenes) names.emplace_back(scene.name);
    if (!workload->file_ending.empty()) endings.emplace_back(workload->file_ending);
  }
  require_name(
      value, "a scene", names,
      endings.empty() ? "" : fmt::format(", or name a file that ends in {}", list_or(endings)));
}

Axis read_axis(const std::string& name, const JsonCursor& member) {
  const Parameter& parameter = *find_parameter(name);
  Axis axis{name, member.where(), {}};
  for (const JsonCursor& value : member.is_array() ? member.items() : std::vector{member}) {
    axis.values.push_back({value.where(), read_value(parameter, value)});
    if (name == "kernel") require_name(value, "a kernel", names_of(kernels()));
    if (name == "scene") require_scene(value);
  }
  if (axis.values.empty()) member.fail("a value or a list of at least one");
  return axis;
}

}  // namespace

std::vector<Axis> read_axes(const JsonCursor& object) {
  std::vector<std::string> names;
  for (const Parameter& parameter : all_parameters()) names.emplace_back(parameter.name());
  object.allow_members(names);
  std::vector<Axis> axes;
  for (const std::string& name : object.member_names())
    axes.push_back(read_axis(name, object.member(name)));
  return axes;
}

}  // namespace lanescope
