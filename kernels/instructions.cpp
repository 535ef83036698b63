// SPDX-License-Identifier: MIT
#include "kernels/instructions.h"

#include <map>
#include <string>

#include "kernels/kernel.h"
#include "simulator/base/error.h"
#include "simulator/program_instructions.h"

namespace lanescope {
namespace {

/// Instructions with distinct mnemonics.
class Instructions {
 public:
  /// Adds an instruction, unless it is there. `what` says whose it is.
  void add(const InstructionInfo& info, std::string what) {
    const auto [known, is_new] = known_.emplace(info.mnemonic, Known{&info, what});
    if (is_new)
      all_.push_back(&info);
    else if (known->second.info != &info)
      throw InputError("instructions",
                       "'{}' is the mnemonic of {} ({}) and of {} ({}); give one of them another",
                       info.mnemonic, known->second.what, known->second.info->meaning, what,
                       info.meaning);
  }
  const std::vector<const InstructionInfo*>& all() const { return all_; }

 private:
  struct Known {
    const InstructionInfo* info;
    std::string what;
  };
  std::map<std::string_view, Known> known_;
  std::vector<const InstructionInfo*> all_;
};

}  // namespace

std::vector<const InstructionInfo*> all_instructions() {
  Instructions instructions;
  for (const InstructionInfo* info : instruction_set())
    instructions.add(*info, "one of the instruction set");
  for (const ProgramInstruction& own : program_instructions())
    instructions.add(*own.info, fmt::format("struct {}", own.struct_name));
  for (const Kernel* kernel : kernels())
    for (const InstructionInfo* info : kernel->instructions)
      instructions.add(*info, fmt::format("one of kernel {}", kernel->name));
  return instructions.all();
}

}  // namespace lanescope
