// SPDX-License-Identifier: MIT
// How the options of an experiment are declared, and what the help says of them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "analysis/cli/defaults.h"
#include "analysis/cli/experiment_arguments.h"

namespace lanescope {
namespace {

constexpr const char* kRun = "Run";

bool has(const std::vector<Parameter>& parameters, std::string_view name) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const Parameter& p) { return p.name() == name; });
}

/// Of the run, of a kind of work, or of kernels.
std::string group_of(const Parameter& parameter) {
  if (has(joined(run_parameters()), parameter.name())) return kRun;
  for (const Workload* workload : workloads())
    if (has(workload->parameters, parameter.name()))
      return fmt::format("Kind of work: {}", workload->name);
  return "Kernels";
}

std::string help_of(const std::vector<const Parameter*>& parameters) {
  std::string help;
  for (const Parameter* parameter : parameters) {
    std::string words(parameter->words.help);
    if (!help.empty()) words[0] = static_cast<char>(std::tolower(words[0]));
    help += (help.empty() ? "" : ", ") + words;
  }
  const Parameter& first = *parameters.front();
  std::vector<std::string> notes;
  if (!first.words.unit.empty()) notes.emplace_back(first.words.unit);
  if (first.kind == Parameter::Kind::kInteger || first.kind == Parameter::Kind::kNumber)
    notes.push_back(first.allowed_values());
  if (!notes.empty()) help += fmt::format(" ({})", fmt::join(notes, "; "));
  if (std::holds_alternative<std::monostate>(first.fallback))
    help += "; as the scene has it if left out";
  return help;
}

/// As the help shows it; empty if it depends on the scene.
std::string default_of(const ExperimentArguments& arguments, const Parameter& parameter) {
  std::vector<std::string> texts;
  const auto add_all = [&](const auto& values) {
    for (const auto& value : values) texts.push_back(value_text(Value(value)));
    if (!arguments.several) texts.resize(1);
  };
  if (const auto own = arguments.defaults.find(parameter.name()); own != arguments.defaults.end())
    add_all(own->second);
  else if (parameter.name() == kKernel)
    add_all(names_of(default_kernels(arguments, usual_workload())));
  else if (parameter.name() == kWidth)
    add_all(usual_widths(*usual_kernels().front()));
  else if (parameter.name() == kScene)
    return std::string(usual_workload().scenes.front().name);
  else if (!std::holds_alternative<std::monostate>(parameter.fallback))
    return value_text(parameter.fallback);
  return fmt::format("{}", fmt::join(texts, ","));
}

void add_option(CommandOptions& options, ExperimentArguments& arguments,
                const std::vector<const Parameter*>& parameters) {
  const std::string name(parameters.front()->words.option);
  std::vector<std::string> defaults;
  for (const Parameter* parameter : parameters)
    defaults.push_back(default_of(arguments, *parameter));
  CLI::Option* const option =
      options.add(group_of(*parameters.front()), {name, form_of(parameters), help_of(parameters)},
                  arguments.texts[name]);
  if (!defaults.front().empty()) option->default_str(fmt::format("{}", fmt::join(defaults, "x")));
}

/// The endings of files that can be scenes: `.obj or .vox`.
std::string file_endings() {
  std::vector<std::string> endings;
  for (const Workload* workload : workloads())
    if (!workload->file_ending.empty()) endings.emplace_back(workload->file_ending);
  return list_or(endings);
}

void add_file_option(CommandOptions& options, ExperimentArguments& arguments) {
  const std::string endings = file_endings();
  if (endings.empty()) return;
  options
      .add(kRun,
           {kFileOption, "FILE", fmt::format("A file instead of a built-in scene ({})", endings)},
           arguments.file)
      ->excludes(options.app().get_option(std::string(find_parameter(kScene)->words.option)));
}

}  // namespace

void add_experiment_options(CommandOptions& options, ExperimentArguments& arguments) {
  const std::vector<const Parameter*> all = pointers(all_parameters());
  for (const Parameter* parameter : all) {
    const auto left_out = [&](const Parameter& p) {
      return std::find(arguments.left_out.begin(), arguments.left_out.end(), p.name()) !=
             arguments.left_out.end();
    };
    const std::vector<const Parameter*> together = of_option(all, parameter->words.option);
    if (together.front() != parameter || left_out(*parameter)) continue;
    add_option(options, arguments, together);
    if (parameter->name() == kScene) add_file_option(options, arguments);
  }
  if (arguments.takes_lists)
    options.app().footer(
        "\nA parameter takes several values, with commas between them; an integer also a range,\n"
        "both ends of which belong to it: --width 8,16 or --width 1:64. Every combination is "
        "run.\n" +
        options.app().get_footer());
}

void add_threads_option(CommandOptions& options, std::string& text) {
  options.add_output({"--threads", "N", "Threads; all of the host if left out"}, text);
}

}  // namespace lanescope
