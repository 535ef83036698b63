// SPDX-License-Identifier: MIT
#include "simulator/issue.h"

namespace lanescope::detail {
namespace {

template <class... Args>
[[noreturn]] void fail(const InstructionInfo& info, int lane, const std::source_location& at,
                       fmt::format_string<Args...> format, Args&&... args) {
  throw CheckError(fmt::format("{}:{}: {}, lane {}: {}", at.file_name(), at.line(), info.mnemonic,
                               lane, fmt::format(format, std::forward<Args>(args)...)));
}

}  // namespace

void fail_block_length(const InstructionInfo& info) {
  throw CheckError(fmt::format(
      "{}: a block issued it more often than its list can hold; open a block inside the loop",
      info.mnemonic));
}

void fail_dead_lane(const InstructionInfo& info, int operand, int lane,
                    const std::source_location& at) {
  fail(info, lane, at, "operand {} is read, but the lane was off when it was computed",
       operand + 1);
}

void fail_bounds(const InstructionInfo& info, int lane, std::int64_t element, std::uint32_t size,
                 std::string_view memory, const std::source_location& at) {
  fail(info, lane, at, "element {} is outside '{}', which has {}", element, memory, size);
}

void fail_unwritten(const InstructionInfo& info, int lane, std::int64_t element,
                    std::string_view memory, const std::source_location& at) {
  fail(info, lane, at, "element {} of '{}' is read, but was never written", element, memory);
}

}  // namespace lanescope::detail
