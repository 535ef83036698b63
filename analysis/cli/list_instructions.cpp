// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/cli/lists.h"
#include "kernels/kernel.h"
#include "simulator/instruction_reference.h"
#include "simulator/instruction_set.h"

namespace lanescope {

std::string reference_of_instructions() { return instruction_reference(reference_entries()); }

std::string list_instructions() {
  std::vector<const InstructionInfo*> all(instruction_set().begin(), instruction_set().end());
  for (const Kernel* kernel : kernels())
    for (const InstructionInfo* own : kernel->instructions)
      if (std::find(all.begin(), all.end(), own) == all.end()) all.push_back(own);
  std::string text;
  for (const InstructionInfo* info : all)
    text += fmt::format("{:<18} {:<11} {:<13} {}\n", info->mnemonic,
                        to_string(info->instruction_class), to_string(info->charge), info->meaning);
  return text;
}

}  // namespace lanescope
