// SPDX-License-Identifier: MIT
#include "simulator/slow_machine.h"

namespace lanescope::detail {

IssueTerms allowing(const IssueTerms& terms, Check check) {
  LANESCOPE_CHECK(has_defined_result(check), "no program can mean what '{}' looks for",
                  to_string(check));
  return {terms.overhead, terms.allowed.with(check)};
}

void charge_or_tell(SlowState& state, const InstructionInfo& info, const OpenedBlock& block,
                    std::uint64_t active, bool overhead, const std::source_location& at) {
  if (state.checked())
    state.tally.charge(block.stage, {&info, overhead}, active);
  else
    state.observer->issued(
        {info, block.stage, state.width().lanes, active, overhead, at, state.touches, block.at});
}

}  // namespace lanescope::detail
