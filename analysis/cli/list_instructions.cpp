// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/cli/lists.h"
#include "analysis/machines/cost_tables.h"
#include "kernels/instructions.h"
#include "simulator/instruction_reference.h"
#include "simulator/instruction_set.h"

namespace lanescope {

std::string reference_of_instructions() {
  return instruction_reference(reference_entries(), machine_prices);
}

std::string list_instructions() {
  std::string text;
  for (const InstructionInfo* info : all_instructions())
    text += fmt::format("{:<18} {:<11} {:<13} {}\n", info->mnemonic,
                        to_string(info->instruction_class), to_string(info->charge), info->meaning);
  return text;
}

}  // namespace lanescope
