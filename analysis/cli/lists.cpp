// SPDX-License-Identifier: MIT
#include "analysis/cli/lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/cli/command.h"
#include "analysis/cli/defaults.h"
#include "analysis/machines/description.h"
#include "analysis/tables/table.h"
#include "kernels/kernel.h"

namespace lanescope {
namespace {

std::string line(std::string_view name, std::string_view text) {
  return fmt::format("{:<30} {}\n", name, text);
}

template <class Descriptors>
std::string name_and_summary(const Descriptors& all) {
  std::string text;
  for (const auto* one : all) text += line(one->name, one->summary);
  return text;
}

std::string list_kernels() {
  std::string text;
  for (const Kernel* kernel : kernels())
    text += line(
        kernel->name,
        fmt::format("{}; takes {}; W = {}", kernel->summary, kernel->workload->name,
                    kernel->most_width == 1 ? "1" : fmt::format("1 to {}", kernel->most_width)));
  return text;
}

std::string list_workloads() { return name_and_summary(workloads()); }

/// The words that stand for a scene and others: `; one of <group>`.
std::string groups_of(const Workload& workload, std::string_view scene) {
  std::string text;
  for (const Study* study : scene_groups(workload))
    if (std::find(study->scenes.begin(), study->scenes.end(), scene) != study->scenes.end())
      text += fmt::format("; one of `{}`", study->scene_group);
  return text;
}

std::string list_scenes() {
  std::string text;
  for (const Workload* workload : workloads()) {
    for (const SceneInfo& scene : workload->scenes)
      text += line(scene.name, fmt::format("{}; of {}{}", scene.summary, workload->name,
                                           groups_of(*workload, scene.name)));
    if (!workload->file_ending.empty())
      text += line(fmt::format("FILE{}", workload->file_ending),
                   fmt::format("{}; of {}", workload->file_kind, workload->name));
  }
  return text;
}

std::string list_tables() {
  std::string text = name_and_summary(tables());
  for (const Study* study : studies())
    for (const Table* table : study->tables())
      text += line(table->name, fmt::format("{}; of the study {}", table->summary, study->name));
  return text;
}

std::string default_text(const Parameter& parameter) {
  if (std::holds_alternative<std::monostate>(parameter.fallback)) return "as the scene has it";
  const std::string text = value_text(parameter.fallback);
  return text.empty() ? "-" : text;
}

std::string list_parameters() {
  std::string text;
  for (const Parameter& parameter : all_parameters()) {
    std::string values = parameter.allowed_values();
    if (!parameter.words.unit.empty()) values += fmt::format(" ({})", parameter.words.unit);
    text +=
        fmt::format("{:<22} {:<24} {:<20} {:<46} {}\n", parameter.name(), parameter.words.option,
                    default_text(parameter), values, takers_of(parameter.name()));
  }
  return text;
}

std::string list_machines() {
  std::string text;
  for (const MachineDescription& machine : shipped_machines())
    text += line(machine.name, machine.summary);
  return text;
}

std::string list_commands() { return name_and_summary(commands()); }

constexpr std::array<List, 9> kLists{{{"kernels", list_kernels},
                                      {"workloads", list_workloads},
                                      {"scenes", list_scenes},
                                      {kInstructionList, list_instructions},
                                      {"parameters", list_parameters},
                                      {"tables", list_tables},
                                      {"machines", list_machines},
                                      {"studies", list_studies},
                                      {"commands", list_commands}}};

}  // namespace

std::span<const List> lists() { return kLists; }

std::string list_studies() { return name_and_summary(studies()); }

}  // namespace lanescope
