// SPDX-License-Identifier: MIT
#include "analysis/configuration/special_options.h"

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

}  // namespace

std::vector<SpecialOption> special_options(const Configuration& configuration) {
  static const std::vector<Parameter> kNone;
  const Kernel* const kernel = known_kernel(configuration.kernel);
  const auto& of_source = kernel ? kernel->workload->parameters : kNone;
  const auto& of_kernel = kernel ? kernel->parameters : kNone;
  std::vector<SpecialOption> options;
  std::vector<bool> special;
  for (const auto& [name, value] : configuration.arguments.all()) {
    if (value == Value()) continue;
    const Parameter* const source_parameter = find(of_source, name);
    const Parameter* const parameter = source_parameter ? source_parameter : find(of_kernel, name);
    const std::string option = parameter ? option_of(*parameter) : name;
    if (options.empty() || options.back().option != option) {
      options.push_back({name, option, value_text(value), source_parameter != nullptr,
                         parameter && parameter->fallback == Value()});
      special.push_back(false);
    } else {
      options.back().value += 'x' + value_text(value);
    }
    if (!parameter || parameter->fallback != value) special.back() = true;
  }
  std::size_t place = 0;
  std::erase_if(options, [&](const SpecialOption&) { return !special[place++]; });
  return options;
}

std::string scene_title(const Configuration& configuration) {
  std::string title = configuration.scene;
  for (const SpecialOption& option : special_options(configuration))
    if (option.by_scene) title += ", " + option.text();
  return title;
}

}  // namespace lanescope
