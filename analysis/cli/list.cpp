// SPDX-License-Identifier: MIT
// `lanescope list`: what there is to choose from.
#include <fmt/format.h>

#include <memory>

#include "analysis/cli/lists.h"
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"

namespace lanescope {
namespace {

struct Given {
  std::string what;
  bool reference = false;
};

void list(const Given& given) {
  const std::vector<std::string> names = names_of(lists());
  if (given.what.empty()) throw InputError("list", "of what? Use {}", list_or(names));
  const std::string chosen = parse_name({"list", given.what}, "a list", names);
  if (given.reference && chosen != kInstructionList)
    throw InputError("--reference", "there is one of {} only; leave it out", kInstructionList);
  for (const List& list : lists())
    if (list.name == chosen) print(given.reference ? reference_of_instructions() : list.text());
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_argument({"what", "WHAT", list_or(names_of(lists()))}, given->what);
  options.add_output_flag("--reference", "The whole reference of instructions, in Markdown",
                          given->reference);
  return [given] { list(*given); };
}

}  // namespace

extern const Command c_list{"list", "Lists what there is: kernels, scenes, parameters and others",
                            "  lanescope list kernels\n"
                            "  lanescope list parameters\n"
                            "  lanescope list instructions",
                            declare};

}  // namespace lanescope
