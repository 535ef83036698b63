// SPDX-License-Identifier: MIT
#include "simulator/slow_machine.h"

namespace lanescope::detail {

void charge_slowly(SlowState& state, const InstructionInfo& info, std::size_t stage,
                   std::uint64_t active, bool overhead, const std::source_location& at) {
  state.tally.charge(stage, {&info, overhead}, active);
  if (state.observer)
    state.observer->issued({info, stage, state.width().lanes, active, overhead, at, state.touches});
}

}  // namespace lanescope::detail
