// SPDX-License-Identifier: MIT
#include "analysis/cli/selection.h"

#include <fmt/format.h>

#include <algorithm>

namespace lanescope {
namespace {

/// An option that was given: runs have one of these values.
struct Condition {
  std::string option;
  std::string text;
  ParameterAxis axis;

  std::vector<Value> values_in(const Configuration& configuration) const {
    std::vector<Value> values;
    for (const std::string& parameter : axis.parameters)
      values.push_back(value_of(configuration, parameter));
    return values;
  }
  bool holds(const Configuration& configuration) const {
    return std::find(axis.rows.begin(), axis.rows.end(), values_in(configuration)) !=
           axis.rows.end();
  }
};

/// Scenes as the report names them: words for several become their names.
ParameterAxis scenes_of(const Argument& argument) {
  std::vector<Value> scenes;
  for (const Argument& element : parse_list(argument)) {
    std::vector<std::string> several;
    for (const Workload* workload : workloads())
      for (std::string& scene : scenes_of_word(element.text, *workload))
        several.push_back(std::move(scene));
    if (several.empty()) several.emplace_back(element.text);
    scenes.insert(scenes.end(), several.begin(), several.end());
  }
  return single_axis(kScene, scenes);
}

std::vector<Condition> conditions(const ExperimentArguments& arguments) {
  std::vector<Condition> all;
  for (const auto& [option, text] : arguments.texts) {
    if (text.empty()) continue;
    const auto parameters = of_option(pointers(all_parameters()), option);
    const Argument argument{option, text};
    all.push_back({option, text,
                   parameters.front()->name() == kScene ? scenes_of(argument)
                                                        : parse_axis(argument, parameters)});
  }
  if (!arguments.file.empty())
    all.push_back({kFileOption, arguments.file, single_axis(kScene, {arguments.file})});
  return all;
}

/// What runs have for an option, each once: `8, 16 or 64`.
std::string values_of(const Condition& condition, const Report& report) {
  std::vector<std::string> texts;
  for (const RunRecord& run : report.runs) {
    std::vector<std::string> words;
    for (const Value& value : condition.values_in(run.configuration))
      words.push_back(value_text(value));
    const std::string text = fmt::format("{}", fmt::join(words, "x"));
    if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
  }
  return list_or(texts);
}

}  // namespace

Report selected(NamedReport source, const ExperimentArguments& arguments) {
  Report report = std::move(source.report);
  const std::size_t all = report.runs.size();
  for (const Condition& condition : conditions(arguments)) {
    const auto holds = [&](const RunRecord& run) { return condition.holds(run.configuration); };
    if (!report.runs.empty() && std::none_of(report.runs.begin(), report.runs.end(), holds))
      throw InputError(condition.option, "'{}' selects no run of {}; {} have {}", condition.text,
                       source.name,
                       report.runs.size() == all ? "its runs" : "those that other options select",
                       values_of(condition, report));
    std::erase_if(report.runs, [&](const RunRecord& run) { return !holds(run); });
  }
  return report;
}

}  // namespace lanescope
