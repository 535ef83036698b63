// SPDX-License-Identifier: MIT
#include "simulator/checks.h"

#include <algorithm>
#include <bit>

#include "simulator/base/error.h"
#include "simulator/machine.h"

namespace lanescope::detail {
namespace {

/// `who` is a lane or lanes.
template <class... Args>
[[noreturn]] void fail(const InstructionInfo& info, std::string_view who,
                       const std::source_location& at, fmt::format_string<Args...> format,
                       Args&&... args) {
  throw CheckError(fmt::format("{}:{}: {}, {}: {}", at.file_name(), at.line(), info.mnemonic, who,
                               fmt::format(format, std::forward<Args>(args)...)));
}

std::string lane_name(int lane) { return fmt::format("lane {}", lane); }

}  // namespace

void fail_width(int width, int lanes) {
  throw CheckError(fmt::format("a machine of {} lanes cannot be {} wide", lanes, width));
}

void fail_stage(std::size_t stage, std::size_t stage_count) {
  throw CheckError(
      fmt::format("a site of stage {}, in a program that has {} stages", stage, stage_count));
}

void fail_dead_lane(const InstructionInfo& info, int operand, int lane,
                    const std::source_location& at) {
  fail(info, lane_name(lane), at, "operand {} is read, but the lane was off when it was computed",
       operand + 1);
}

void fail_bounds(const InstructionInfo& info, int lane, std::int64_t element, std::size_t size,
                 std::string_view memory, const std::source_location& at) {
  fail(info, lane_name(lane), at, "element {} is outside '{}', which has {}", element, memory,
       size);
}

void fail_unwritten(const InstructionInfo& info, int lane, std::int64_t element,
                    std::string_view memory, const std::source_location& at) {
  fail(info, lane_name(lane), at, "element {} of '{}' is read, but was never written", element,
       memory);
}

void fail_beyond_width(std::uint64_t active, Width width, const std::source_location& at) {
  throw CheckError(fmt::format("{}:{}: a block has lane {} on, of a machine that is {} wide",
                               at.file_name(), at.line(), std::bit_width(active) - 1, width.lanes));
}

void StoredElements::require_distinct(const InstructionInfo& info, std::string_view memory,
                                      const std::source_location& at) {
  // Lanes mostly store in ascending order.
  const auto not_ascending = [](const auto& a, const auto& b) { return a.first >= b.first; };
  if (std::ranges::adjacent_find(stored_, not_ascending) == stored_.end()) return;
  std::ranges::sort(stored_);
  const auto both = std::ranges::adjacent_find(stored_, [](const auto& a, const auto& b) {
    return a.first == b.first && a.second != b.second;
  });
  if (both == stored_.end()) return;
  fail(info, fmt::format("lanes {} and {}", both->second, std::next(both)->second), at,
       "both store to element {} of '{}', in one instruction", both->first, memory);
}

}  // namespace lanescope::detail
