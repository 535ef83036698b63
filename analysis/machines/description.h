// SPDX-License-Identifier: MIT
// A machine as data: how many lanes its vectors have, and what each instruction takes there, in
// issue slots. docs/machines.md defines the terms and the format.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/choice.h"
#include "simulator/sequences.h"

namespace lanescope {

/// What the slots of an instruction are counted by.
enum class SlotBasis {
  kInstruction,  ///< Each execution, at any width.
  kEveryGroup,   ///< Each group of N lanes of the vector, whatever is on.
  kGroupPair,    ///< Each pair of groups: what moves lanes from any of them to any other.
  kActiveGroup,  ///< Each group with a lane on.
  kDenseGroup,   ///< Lanes on / N, rounded up.
  kLane,         ///< Each lane that is on.
  kLine,         ///< Each distinct line of memory that is touched.
};

inline constexpr std::array<Choice<SlotBasis>, 7> kSlotBases{
    {{"instruction", SlotBasis::kInstruction},
     {"every_group", SlotBasis::kEveryGroup},
     {"group_pair", SlotBasis::kGroupPair},
     {"active_group", SlotBasis::kActiveGroup},
     {"dense_group", SlotBasis::kDenseGroup},
     {"lane", SlotBasis::kLane},
     {"line", SlotBasis::kLine}}};

/// A number for each basis.
using ByBasis = std::array<double, kSlotBases.size()>;

inline double& at(ByBasis& numbers, SlotBasis basis) {
  return numbers[static_cast<std::size_t>(basis)];
}
inline double at(const ByBasis& numbers, SlotBasis basis) {
  return numbers[static_cast<std::size_t>(basis)];
}

/// The source of a figure that has none.
inline constexpr std::string_view kAssumed = "assumed";

/// What an instruction takes.
struct SlotFigure {
  bool known = true;                       ///< If not, nobody knows: there is nothing else.
  ByBasis slots{};                         ///< For each of what they are counted by.
  const SequenceInfo* sequence = nullptr;  ///< Issued beside these slots; or null.
  std::string source;                      ///< Of the slots: a text, or `assumed`.
};

/// Figures by mnemonic, or by the name of a class.
using SlotFigures = std::map<std::string, SlotFigure, std::less<>>;

struct MachineDescription {
  std::string name;
  std::string summary;
  /// Of its text, and of those that it inherits from.
  std::uint64_t hash = 0;
  /// N; none if its vectors are as wide as those of the run.
  std::optional<int> lanes;
  std::map<std::string, std::string, std::less<>> sources;  ///< Texts by what figures call them.
  SlotFigures classes;       ///< Of instructions that have no figure of their own.
  SlotFigures instructions;  ///< Of the instruction set, and of what sequences issue beside it.
  SlotFigures own;           ///< Of instructions from outside the set.

  /// The figure of an instruction: its own, or that of its class; null if there is neither.
  const SlotFigure* find(std::string_view mnemonic, std::string_view instruction_class) const;
  /// Whether the instruction has a figure by its name.
  bool names(std::string_view mnemonic) const;
};

/// The instructions that every description has a figure for: the set, and what sequences issue
/// beside it.
std::vector<const InstructionInfo*> priced_instructions();

/// Finds the machine that a description inherits from; null if there is none of that name.
using FindMachine = std::function<const MachineDescription*(std::string_view name)>;

/// Reads a description from its JSON text. Throws InputError, beginning with where, for what is not
/// one: members that are not known, sequences that replace another instruction or that need
/// themselves, and instructions of the set without a figure, which it lists.
MachineDescription read_machine(std::string_view text, const std::string& file,
                                const FindMachine& find, const std::vector<std::string>& known);

/// The machines that the program comes with, in the order of analysis/machines/CMakeLists.txt.
const std::vector<MachineDescription>& shipped_machines();

/// One of these by its name, or the description in a file, which may inherit from one of them.
/// Throws InputError, beginning with `where`, if there is neither.
MachineDescription machine_of(std::string_view where, const std::string& name_or_file);

/// The JSON Schema of descriptions.
std::string machine_json_schema();

}  // namespace lanescope
