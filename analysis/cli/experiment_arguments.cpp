// SPDX-License-Identifier: MIT
#include "analysis/cli/experiment_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/cli/defaults.h"
#include "analysis/configuration/configuration_json.h"

namespace lanescope {
namespace {

constexpr std::string_view kAllScenes = "all";

const std::string& text_of(const ExperimentArguments& arguments, std::string_view option) {
  static const std::string kNothing;
  const auto found = arguments.texts.find(option);
  return found == arguments.texts.end() ? kNothing : found->second;
}

/// The text for a parameter of every run.
Argument argument_of(const ExperimentArguments& arguments, std::string_view run_parameter) {
  const std::string_view option = find_parameter(run_parameter)->words.option;
  return {option, text_of(arguments, option)};
}

std::vector<Value> scenes_of_list(const Argument& argument, const Workload& workload) {
  std::vector<Value> scenes;
  const std::vector<Argument> elements = parse_list(argument);
  for (const Argument& element : elements) {
    const std::vector<std::string> several = scenes_of_word(element.text, workload);
    if (several.empty()) {
      scenes.emplace_back(std::string(element.text));
      continue;
    }
    if (elements.size() > 1)
      throw InputError(element.option, "'{}' stands for several scenes; use it alone",
                       element.text);
    return {several.begin(), several.end()};
  }
  return scenes;
}

void require_file(const std::string& file, const Workload& workload) {
  if (const std::string problem = scene_name_problem(file); !problem.empty())
    throw InputError(kFileOption, "{}", problem);
  if (workload.is_file(file)) return;
  if (workload.file_ending.empty())
    throw InputError(kFileOption, "scenes of {} are no files; leave it out", workload.name);
  throw InputError(kFileOption, "'{}' is not {} file ({})", file, workload.file_kind,
                   workload.file_ending);
}

/// Makes the configurations that arguments ask for.
class Resolution {
 public:
  explicit Resolution(const ExperimentArguments& arguments)
      : arguments_(arguments), kernels_(kernels_asked_for()), workload_(*kernels_[0]->workload) {}

  std::vector<Configuration> run() {
    require_one_kind();
    require_takers();
    std::vector<std::vector<ParameterAxis>> kernel_axes;
    const std::vector<Arguments> settings = cross(setting_axes(), {});
    for (const Kernel* kernel : kernels_) kernel_axes.push_back(axes_of(*kernel));
    for (Arguments setting : settings)
      for (std::size_t i = 0; i < kernels_.size(); ++i) {
        setting.set(kKernel, std::string(kernels_[i]->name));
        for (const Arguments& whole : cross(kernel_axes[i], setting)) add(resolved(whole));
      }
    require_effect();
    return std::move(configurations_);
  }

 private:
  std::vector<const Kernel*> kernels_asked_for() const {
    const Argument argument = argument_of(arguments_, kKernel);
    std::vector<const Kernel*> chosen;
    const auto choose = [&](const Value& name) {
      Arguments given;
      given.set(kKernel, name);
      chosen.push_back(known_kernel(resolved(given).kernel));  // Refuses names of no kernel.
    };
    if (!argument.text.empty())
      for (const Argument& element : parse_list(argument)) choose(std::string(element.text));
    else if (const auto own = arguments_.defaults.find(kKernel); own != arguments_.defaults.end())
      for (const Value& name : own->second) choose(name);
    else
      chosen = default_kernels(arguments_, kind_asked_for());
    return chosen;
  }

  /// The kind of work that has the scene, or the first of the scenes; the usual one if none has.
  const Workload& kind_asked_for() const {
    const std::string_view scenes = argument_of(arguments_, kScene).text;
    const std::string_view scene = scenes.substr(0, scenes.find(','));
    for (const Workload* workload : workloads())
      if (workload->is_file(arguments_.file) || workload->is_file(scene) ||
          workload->find_scene(scene) || !scenes_of_word(scene, *workload).empty())
        return *workload;
    return usual_workload();
  }

  void require_one_kind() const {
    for (const Kernel* kernel : kernels_)
      if (kernel->workload != &workload_)
        throw InputError(find_parameter(kKernel)->words.option,
                         "{} takes {}, and {} takes {}; name kernels of one kind of work",
                         kernels_[0]->name, workload_.name, kernel->name, kernel->workload->name);
  }

  /// An option that no kernel takes is a mistake; one that some take is for those.
  void require_takers() const {
    for (const auto& [option, text] : arguments_.texts) {
      const auto takes = [&, &word = option](const Kernel* kernel) {
        const std::vector<Parameter> parameters = parameters_of(*kernel);
        return !of_option(pointers(parameters), word).empty();
      };
      if (text.empty() || std::any_of(kernels_.begin(), kernels_.end(), takes)) continue;
      const std::string takers(
          takers_of(of_option(pointers(all_parameters()), option).front()->name()));
      throw InputError(option, "{} {} not take it; {} {}", list_and(names_of(kernels_)),
                       kernels_.size() == 1 ? "does" : "do", takers,
                       takers.find(" and ") == takers.npos ? "does" : "do");
    }
  }

  /// An option that is nothing in every configuration is a mistake, too.
  void require_effect() const {
    for (const auto& [option, text] : arguments_.texts) {
      const std::vector<const Parameter*> parameters =
          of_option(pointers(all_parameters()), option);
      const auto applies = [&](const Configuration& c) {
        return std::any_of(parameters.begin(), parameters.end(), [&](const Parameter* p) {
          return !std::holds_alternative<std::monostate>(value_of(c, p->name()));
        });
      };
      if (!text.empty() && std::none_of(configurations_.begin(), configurations_.end(), applies))
        throw InputError(option, "does not apply to any scene of the command");
    }
  }

  std::vector<Value> scenes() const {
    if (!arguments_.file.empty()) {
      require_file(arguments_.file, workload_);
      return {arguments_.file};
    }
    const Argument argument = argument_of(arguments_, kScene);
    if (!argument.text.empty()) return scenes_of_list(argument, workload_);
    if (const auto own = arguments_.defaults.find(kScene); own != arguments_.defaults.end())
      return scenes_of_list({argument.option, std::get<std::string>(own->second.front())},
                            workload_);
    return {std::string(workload_.scenes.front().name)};
  }

  /// What kernels are compared on: the scene, the parameters of the kind of work, and those of
  /// every run but for the width.
  std::vector<ParameterAxis> setting_axes() const {
    std::vector<const Parameter*> parameters = pointers(workload_.parameters);
    for (const auto& binding : run_parameters()) {
      const std::string_view name = binding.parameter().name();
      if (name != kKernel && name != kScene && name != kWidth)
        parameters.push_back(&binding.parameter());
    }
    std::vector<ParameterAxis> axes = axes_of(parameters);
    axes.insert(axes.begin(), single_axis(kScene, scenes()));
    return axes;
  }

  /// Of those parameters that the command line or the command has values for.
  std::vector<ParameterAxis> axes_of(const std::vector<const Parameter*>& parameters) const {
    std::vector<ParameterAxis> axes;
    for (const Parameter* parameter : parameters) {
      const std::string_view option = parameter->words.option;
      const std::string& text = text_of(arguments_, option);
      const auto own = arguments_.defaults.find(parameter->name());
      if (!text.empty()) {
        const auto together = of_option(parameters, option);
        if (together.front() == parameter) axes.push_back(parse_axis({option, text}, together));
      } else if (own != arguments_.defaults.end()) {
        axes.push_back(single_axis(parameter->name(), own->second));
      }
    }
    return axes;
  }

  /// Of the parameters of the kernel, and its width.
  std::vector<ParameterAxis> axes_of(const Kernel& kernel) const {
    std::vector<const Parameter*> parameters = pointers(kernel.parameters);
    const Parameter* const width = find_parameter(kWidth);
    const bool is_given =
        !text_of(arguments_, width->words.option).empty() || arguments_.defaults.contains(kWidth);
    if (is_given && !is_scalar_beside_others(kernel)) {
      parameters.push_back(width);
      return axes_of(parameters);
    }
    std::vector<ParameterAxis> axes = axes_of(parameters);
    std::vector<std::uint64_t> widths = usual_widths(kernel);
    if (!arguments_.several) widths.resize(1);
    axes.push_back(single_axis(kWidth, {widths.begin(), widths.end()}));
    return axes;
  }

  /// Widths that are asked for are of kernels that have lanes: a scalar one beside them runs as it
  /// is.
  bool is_scalar_beside_others(const Kernel& kernel) const {
    return kernel.most_width == 1 &&
           std::any_of(kernels_.begin(), kernels_.end(),
                       [](const Kernel* other) { return other->most_width > 1; });
  }

  /// Values that a scene or a kernel does not have leave configurations equal.
  void add(const Configuration& configuration) {
    if (!known_.insert(configuration_json(configuration).dump()).second) return;
    configurations_.push_back(configuration);
    require_few(configurations_.size());
  }

  const ExperimentArguments& arguments_;
  std::vector<const Kernel*> kernels_;
  const Workload& workload_;
  std::vector<Configuration> configurations_;
  std::set<std::string> known_;
};

}  // namespace

std::vector<const Kernel*> default_kernels(const ExperimentArguments& arguments,
                                           const Workload& workload) {
  const std::vector<const Kernel*> usual = usual_kernels(workload);
  if (arguments.several) return usual;
  return {arguments.takes_last_kernel ? usual.back() : usual.front()};
}

std::vector<std::string> scenes_of_word(std::string_view word, const Workload& workload) {
  if (word == kAllScenes) return names_of(workload.scenes);
  for (const Study* study : scene_groups(workload))
    if (word == study->scene_group) return {study->scenes.begin(), study->scenes.end()};
  return {};
}

std::vector<Configuration> resolve_configurations(const ExperimentArguments& arguments) {
  return Resolution(arguments).run();
}

}  // namespace lanescope
