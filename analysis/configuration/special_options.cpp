// SPDX-License-Identifier: MIT
#include "analysis/configuration/special_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace lanescope {
namespace {

const Parameter* find(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& p) { return p.name() == name; });
  return found == parameters.end() ? nullptr : &*found;
}

std::string option_of(const Parameter& parameter) {
  const std::string_view option = parameter.words.option;
  return std::string(option.substr(std::min(option.find_first_not_of('-'), option.size())));
}

/// An option of several runs.
struct StatedOption {
  std::string name;
  std::vector<std::string> values;  ///< Different ones.
  bool stated = false;              ///< Of one of the runs.
  bool by_scene = false;
};

void add_options(std::vector<StatedOption>& all, const Configuration& configuration) {
  const Kernel* const kernel = known_kernel(configuration.kernel);
  for (const NamedOption& option : named_options(configuration)) {
    if (kernel && option.parameter == kernel->workload->facet) continue;
    auto at = std::find_if(all.begin(), all.end(),
                           [&](const StatedOption& other) { return other.name == option.option; });
    if (at == all.end()) at = all.insert(all.end(), StatedOption{option.option, {}});
    at->stated |= option.stated;
    at->by_scene |= option.by_scene;
    if (std::find(at->values.begin(), at->values.end(), option.value) == at->values.end())
      at->values.push_back(option.value);
  }
}

}  // namespace

std::vector<NamedOption> named_options(const Configuration& configuration) {
  static const std::vector<Parameter> kNone;
  const Kernel* const kernel = known_kernel(configuration.kernel);
  const auto& of_source = kernel ? kernel->workload->parameters : kNone;
  const auto& of_kernel = kernel ? kernel->parameters : kNone;
  std::vector<NamedOption> options;
  for (const auto& [name, value] : configuration.arguments.all()) {
    if (value == Value()) continue;
    const Parameter* const source_parameter = find(of_source, name);
    const Parameter* const parameter = source_parameter ? source_parameter : find(of_kernel, name);
    const std::string option = parameter ? option_of(*parameter) : name;
    if (options.empty() || options.back().option != option) {
      options.push_back({name, option, value_text(value), source_parameter != nullptr,
                         parameter && parameter->fallback == Value(), false,
                         parameter && parameter->words.stated == Stated::kAlways});
    } else {
      options.back().value += 'x' + value_text(value);
    }
    NamedOption& last = options.back();
    last.special |= !parameter || parameter->fallback != value;
    last.stated |= last.special;
  }
  return options;
}

std::vector<NamedOption> special_options(const Configuration& configuration) {
  std::vector<NamedOption> options = named_options(configuration);
  std::erase_if(options, [](const NamedOption& option) { return !option.special; });
  return options;
}

std::string shown_setting(const std::vector<const Configuration*>& configurations) {
  std::vector<StatedOption> options;
  for (const Configuration* configuration : configurations) add_options(options, *configuration);
  std::vector<std::string> texts;
  for (const StatedOption& option : options)
    if (option.stated && !(option.by_scene && option.values.size() > 1))
      texts.push_back(fmt::format("{} = {}", option.name, fmt::join(option.values, " and ")));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string scene_title(const Configuration& configuration) {
  std::string title = configuration.scene;
  for (const NamedOption& option : special_options(configuration))
    if (option.by_scene) title += ", " + option.text();
  return title;
}

}  // namespace lanescope
