// SPDX-License-Identifier: MIT
#include "analysis/configuration/configuration.h"

#include <algorithm>

#include "analysis/base/printable.h"

namespace lanescope {
namespace {

const Binding<Configuration>* find_run_parameter(std::string_view name) {
  for (const auto& binding : run_parameters())
    if (binding.parameter().name() == name) return &binding;
  return nullptr;
}

/// The value that was given, or the default. Throws ParameterError for one that is not allowed.
Value given_or_default(const Parameter& parameter, const Arguments& given) {
  if (!given.contains(parameter.name())) return parameter.fallback;
  const Value& value = given[parameter.name()];
  if (!parameter.allows(value))
    throw ParameterError(parameter.words, fmt::format("{} is not {}", value_text(value),
                                                      parameter.allowed_values()));
  return value;
}

/// The kernel that runs if none is named: the first that issues instructions, if one does.
const Kernel& usual_kernel() {
  for (const Kernel* kernel : kernels())
    if (!kernel->stages.empty()) return *kernel;
  return *kernels().front();
}

const Kernel& kernel_of(const Arguments& given) {
  if (!given.contains("kernel")) return usual_kernel();
  const auto& name = std::get<std::string>(given["kernel"]);
  if (const Kernel* kernel = known_kernel(name)) return *kernel;
  const auto names = names_of(kernels());
  throw ParameterError(find_run_parameter("kernel")->parameter().words,
                       fmt::format("'{}' is not a kernel; use {}{}", name, list_or(names),
                                   did_you_mean(name, names)));
}

void check_scene(const std::string& scene, const Workload& workload) {
  if (std::string problem = scene_name_problem(scene); !problem.empty())
    throw ParameterError(find_run_parameter("scene")->parameter().words, std::move(problem));
  if (workload.find_scene(scene) || workload.is_file(scene)) return;
  const auto names = names_of(workload.scenes);
  const std::string file =
      workload.file_ending.empty()
          ? ""
          : fmt::format(", or name {} file ({})", workload.file_kind, workload.file_ending);
  throw ParameterError(find_run_parameter("scene")->parameter().words,
                       fmt::format("'{}' is not a scene of {}; use {}{}{}", scene, workload.name,
                                   list_or(names), file, did_you_mean(scene, names)));
}

void check_width(const Configuration& c, const Kernel& kernel) {
  if (c.width <= kernel.most_width) return;
  throw ParameterError(
      find_run_parameter("width_lanes")->parameter().words,
      kernel.most_width == 1
          ? fmt::format("{} is not a width of {}; it is scalar, use 1", c.width, kernel.name)
          : fmt::format("{} is not a width of {}; use 1 to {}", c.width, kernel.name,
                        kernel.most_width));
}

}  // namespace

const Parameters<Configuration>& run_parameters() {
  using C = Configuration;
  static const Parameters<C> all{
      {&C::kernel, {"kernel", "--kernel", kNoUnit, "The vector program that runs"}},
      {&C::width, {"width_lanes", "--width", "lanes", "Width W of the machine"}, 1, kMostWidth},
      {&C::scene, {"scene", "--scene", kNoUnit, "A built-in scene, or a file"}},
      {&C::mode, {"mode", "--mode", kNoUnit, "How the machine runs the program"}, kModes},
      {&C::observe_every,
       {"observe_every", "--observe-every", "pieces",
        "Memory and source lines are observed in one piece of work of N; 0 in none, 1 in all"},
       0,
       1 << 20},
  };
  return all;
}

std::vector<Parameter> parameters_of(const Kernel& kernel) {
  std::vector<Parameter> all = joined(run_parameters());
  all.insert(all.end(), kernel.workload->parameters.begin(), kernel.workload->parameters.end());
  all.insert(all.end(), kernel.parameters.begin(), kernel.parameters.end());
  return all;
}

const std::vector<Parameter>& all_parameters() {
  static const std::vector<Parameter> all = [] {
    std::vector<Parameter> parameters;
    for (const Kernel* kernel : kernels())
      for (Parameter& p : parameters_of(*kernel))
        if (std::none_of(parameters.begin(), parameters.end(),
                         [&](const Parameter& known) { return known.name() == p.name(); }))
          parameters.push_back(std::move(p));
    return parameters;
  }();
  return all;
}

const Parameter* find_parameter(std::string_view name) {
  const auto& all = all_parameters();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name() == name; });
  return found == all.end() ? nullptr : &*found;
}

bool takes(const Kernel& kernel, std::string_view parameter) {
  const std::vector<Parameter> all = parameters_of(kernel);
  return std::any_of(all.begin(), all.end(),
                     [&](const Parameter& p) { return p.name() == parameter; });
}

std::string takers_of(std::string_view parameter) {
  std::vector<std::string> takers;
  for (const Kernel* kernel : kernels())
    if (takes(*kernel, parameter)) takers.emplace_back(kernel->name);
  if (takers.size() == kernels().size()) return "every kernel";
  return list_and(takers);
}

std::string scene_name_problem(std::string_view scene) {
  if (is_printable(scene)) return {};
  return fmt::format(
      "'{}' is not text in UTF-8 without control characters, as a report has it; rename the file",
      printable(scene));
}

Value value_of(const Configuration& configuration, std::string_view parameter) {
  if (const auto* binding = find_run_parameter(parameter)) return binding->get(configuration);
  return configuration.arguments[parameter];
}

void set_value(Configuration& configuration, std::string_view parameter, Value value) {
  if (const auto* binding = find_run_parameter(parameter))
    binding->set(configuration, value);
  else
    configuration.arguments.set(parameter, std::move(value));
}

Arguments all_values(const Configuration& configuration) {
  Arguments all = encoded(run_parameters(), configuration);
  for (const auto& [name, value] : configuration.arguments.all()) all.set(name, value);
  return all;
}

Configuration resolved(const Arguments& given) {
  const Kernel& kernel = kernel_of(given);
  const Workload& workload = *kernel.workload;
  Configuration c;
  c.kernel = kernel.name;
  c.scene = workload.scenes.front().name;
  c.width = std::min(c.width, kernel.most_width);
  for (const auto& binding : run_parameters())
    if (given.contains(binding.parameter().name()))
      binding.set(c, given_or_default(binding.parameter(), given));
  for (const auto* parameters : {&workload.parameters, &kernel.parameters})
    for (const Parameter& p : *parameters) c.arguments.set(p.name(), given_or_default(p, given));
  check_scene(c.scene, workload);
  check_width(c, kernel);
  workload.resolve(c.scene, c.arguments);
  return c;
}

const Workload& workload_of(const Configuration& configuration) {
  return *find_kernel(configuration.kernel).workload;
}

std::unique_ptr<Source> open_source(const Configuration& configuration,
                                    const OpeningListener& listener) {
  std::unique_ptr<Source> source =
      workload_of(configuration)
          .open(configuration.scene, configuration.arguments, listener.progress);
  if (listener.note)
    for (const std::string& note : source->notes()) listener.note(note);
  return source;
}

bool same_source(const Configuration& a, const Configuration& b) {
  const Workload& workload = workload_of(a);
  return &workload == &workload_of(b) && a.scene == b.scene &&
         std::all_of(
             workload.parameters.begin(), workload.parameters.end(),
             [&](const Parameter& p) { return a.arguments[p.name()] == b.arguments[p.name()]; });
}

std::string facet_of(const Configuration& configuration) {
  const Kernel* const kernel = known_kernel(configuration.kernel);
  if (!kernel || kernel->workload->facet.empty()) return {};
  return value_text(configuration.arguments[kernel->workload->facet]);
}

}  // namespace lanescope
