// SPDX-License-Identifier: MIT
#include "simulator/slow_machine.h"

namespace lanescope::detail {

void charge_or_tell(SlowState& state, const InstructionInfo& info, std::size_t stage,
                    std::uint64_t active, bool overhead, const std::source_location& at) {
  if (state.checked)
    state.tally.charge(stage, {&info, overhead}, active);
  else
    state.observer->issued({info, stage, state.width().lanes, active, overhead, at, state.touches});
}

}  // namespace lanescope::detail
