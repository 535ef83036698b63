// SPDX-License-Identifier: MIT
#include "simulator/checks.h"

#include <algorithm>
#include <bit>

#include "simulator/base/error.h"
#include "simulator/machine.h"

namespace lanescope {

std::string_view to_string(Check check) {
  switch (check) {
    case Check::kDeadLane:
      return "dead_lane";
    case Check::kBeyondWidth:
      return "beyond_width";
    case Check::kBounds:
      return "bounds";
    case Check::kUnwritten:
      return "unwritten";
    case Check::kConflict:
      return "conflict";
    case Check::kShiftCount:
      return "shift_count";
    case Check::kConversion:
      return "conversion";
    case Check::kDivision:
      return "division";
    case Check::kLaneIndex:
      return "lane_index";
    case Check::kNan:
      return "nan";
    case Check::kNoLane:
      return "no_lane";
    case Check::kWidth:
      return "width";
    case Check::kOperand:
      return "operand";
  }
  return {};
}

namespace detail {
namespace {

/// `who` is a lane or lanes.
template <class... Args>
[[noreturn]] void fail(Check check, const InstructionInfo& info, std::string_view who,
                       const std::source_location& at, fmt::format_string<Args...> format,
                       Args&&... args) {
  throw FailedCheck(check,
                    fmt::format("{}:{}: {}, {}: {}", at.file_name(), at.line(), info.mnemonic, who,
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
  fail(Check::kDeadLane, info, lane_name(lane), at,
       "operand {} is read, but the lane was off when it was computed", operand + 1);
}

void fail_bounds(const InstructionInfo& info, int lane, std::int64_t element, std::size_t size,
                 std::string_view memory, const std::source_location& at) {
  fail(Check::kBounds, info, lane_name(lane), at, "element {} is outside '{}', which has {}",
       element, memory, size);
}

void fail_unwritten(const InstructionInfo& info, int lane, std::int64_t element,
                    std::string_view memory, const std::source_location& at) {
  fail(Check::kUnwritten, info, lane_name(lane), at,
       "element {} of '{}' is read, but was never written", element, memory);
}

void fail_beyond_width(std::uint64_t active, Width width, const std::source_location& at) {
  throw FailedCheck(
      Check::kBeyondWidth,
      fmt::format("{}:{}: a block has lane {} on, of a machine that is {} wide", at.file_name(),
                  at.line(), std::bit_width(active) - 1, width.lanes));
}

std::string to_text(const LaneValue& value) {
  if (const float* number = std::get_if<float>(&value)) {
    if (std::isnan(*number)) return "nan";
    if (std::floor(*number) == *number && std::abs(*number) < 1e12f)
      return fmt::format("{:.0f}", *number);
  }
  return std::visit([](auto number) { return fmt::format("{}", number); }, value);
}

void fail_suspicious(const InstructionInfo& info, const Suspicion& suspicion, int lane,
                     std::span<const LaneValue> operands, const std::source_location& at) {
  std::string call;
  for (const LaneValue& operand : operands) call += (call.empty() ? "" : ", ") + to_text(operand);
  fail(suspicion.check, info, lane_name(lane), at, "{}, in {}({})", suspicion.reason, info.mnemonic,
       call);
}

void fail_reduction(const InstructionInfo& info, const Suspicion& suspicion,
                    const std::source_location& at) {
  fail(suspicion.check, info, "all lanes", at, "{}", suspicion.reason);
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
  fail(Check::kConflict, info,
       fmt::format("lanes {} and {}", both->second, std::next(both)->second), at,
       "both store to element {} of '{}', in one instruction", both->first, memory);
}

}  // namespace detail
}  // namespace lanescope
