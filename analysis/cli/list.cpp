// SPDX-License-Identifier: MIT
// `lanescope list`: what there is to choose from.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/tables/table.h"
#include "kernels/kernel.h"
#include "simulator/instruction_reference.h"
#include "simulator/instruction_set.h"
#include "workloads/micropolygons/scene.h"

namespace lanescope {
namespace {

std::string line(std::string_view name, std::string_view text) {
  return fmt::format("{:<30} {}\n", name, text);
}

std::string list_kernels() {
  std::string text;
  for (const Kernel* kernel : kernels())
    text += line(kernel->name,
                 fmt::format("{}; W = {}", kernel->summary,
                             kernel->widths.size() == 1
                                 ? fmt::to_string(kernel->widths.front())
                                 : fmt::format("{} to {}", kernel->widths.front(),
                                               kernel->widths.back())));
  return text;
}

std::string list_scenes() {
  std::string text;
  for (const SceneDescriptor* scene : scenes())
    text += line(scene->name,
                 fmt::format("{}; frames 0 to {}{}", scene->summary, scene->frame_count - 1,
                             scene->thesis_like ? "; like the thesis's" : ""));
  return text;
}

std::string list_instructions() {
  std::vector<const InstructionInfo*> infos(instruction_set().begin(), instruction_set().end());
  for (const Kernel* kernel : kernels())
    for (const InstructionInfo* info : kernel->instructions)
      if (std::ranges::find(infos, info) == infos.end()) infos.push_back(info);
  std::string text;
  for (const InstructionInfo* info : infos)
    text += fmt::format("{:<18} {:<11} {:<13} {}\n", info->mnemonic,
                        to_string(info->instruction_class), to_string(info->charge), info->meaning);
  return text;
}

std::string list_tables() {
  std::string text;
  for (const Table* table : tables()) text += line(table->name, table->summary);
  return text;
}

struct List {
  std::string_view name;
  std::string (*text)();
};
constexpr std::array<List, 4> kLists{{{"kernels", list_kernels},
                                      {"scenes", list_scenes},
                                      {"instructions", list_instructions},
                                      {"tables", list_tables}}};

void list(const std::string& what, bool reference) {
  std::vector<std::string> names;
  for (const List& list : kLists) names.emplace_back(list.name);
  if (what.empty()) throw InputError("list", "of what? Use {}", list_or(names));
  const std::string chosen = parse_name({"list", what}, "a list", names);
  if (reference) {
    if (chosen != "instructions")
      throw InputError("--reference", "is of instructions, not of {}", chosen);
    print(instruction_reference(instruction_set()));
    return;
  }
  for (const List& list : kLists)
    if (list.name == chosen) print(list.text());
}

Action declare(CLI::App& app) {
  const auto what = std::make_shared<std::string>();
  app.add_option("what", *what, "kernels, scenes, instructions or tables")->type_name("WHAT");
  const auto reference = std::make_shared<bool>();
  app.add_flag("--reference", *reference, "Of instructions: the whole reference, in Markdown");
  return [what, reference] { list(*what, *reference); };
}

}  // namespace

extern const Command c_list{"list", "Lists kernels, scenes, instructions or tables",
                            "  lanescope list kernels\n"
                            "  lanescope list instructions --reference",
                            declare};

}  // namespace lanescope
