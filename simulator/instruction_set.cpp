// SPDX-License-Identifier: MIT
#include "simulator/instruction_set.h"

#include <array>

namespace lanescope {
namespace {

template <class... Ops>
std::span<const InstructionInfo* const> infos(InstructionList<Ops...>) {
  static constexpr std::array<const InstructionInfo*, sizeof...(Ops)> kInfos{&Ops::kInfo...};
  return kInfos;
}

}  // namespace

std::span<const InstructionInfo* const> instruction_set() { return infos(InstructionSet{}); }

}  // namespace lanescope
