// SPDX-License-Identifier: MIT
// What an instruction takes on a machine at a width. A sequence takes what executing it once at
// that width issues, priced on the machine in turn.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "analysis/machines/description.h"

namespace lanescope {

/// Slots for each of what they are counted by; what is missing for them, if anything.
struct Price {
  ByBasis slots{};
  std::set<std::string> missing;  ///< Mnemonics that have no figure, or an unknown one.
};

/// Factors on the costs of some instructions, by mnemonic: also where sequences issue them.
using CostFactors = std::map<std::string, double, std::less<>>;

/// Slots of so many executions, groups, lanes and lines.
double slots_of(const Price& price, const ByBasis& counted);

/// Groups of the native vectors of a machine in a vector of that width.
int groups_in(const MachineDescription& machine, int width);

/// What one execution with these lanes on is counted by, if it touches that many lines. Groups
/// without a lane on count for nothing: whoever asks knows the mask.
ByBasis counted_once(const MachineDescription& machine, std::uint64_t mask, std::uint64_t lines);

/// What sequences issue at each width, found when it is first asked for.
class SequenceTrials {
 public:
  /// An instruction of a sequence, as it is issued with all lanes on.
  struct Issue {
    const InstructionInfo* info;
    std::uint64_t mask;
    std::uint64_t lines;   ///< Distinct lines that it touches.
    bool follows = false;  ///< It runs under the mask under which the sequence does.
  };
  const std::vector<Issue>& of(const SequenceInfo& sequence, int width);

 private:
  std::map<std::pair<const SequenceInfo*, int>, std::vector<Issue>> trials_;
};

/// The prices of one machine at one width. Keeps references to the machine and to the trials.
class Prices {
 public:
  Prices(const MachineDescription& machine, int width, SequenceTrials& trials,
         CostFactors factors = {})
      : machine_(machine), width_(width), trials_(trials), factors_(std::move(factors)) {}

  /// Found by name, then by class.
  const Price& of(std::string_view mnemonic, std::string_view instruction_class);

 private:
  Price found(std::string_view mnemonic, std::string_view instruction_class);
  void add_sequence(Price& price, const SequenceInfo& sequence, bool is_memory);

  const MachineDescription& machine_;
  int width_;
  SequenceTrials& trials_;
  CostFactors factors_;
  std::map<std::string, Price, std::less<>> prices_;
};

/// The mnemonic of an instruction that issues itself, by way of sequences; empty if there is none.
std::string sequence_that_needs_itself(const MachineDescription& machine);

}  // namespace lanescope
