// SPDX-License-Identifier: MIT
// The mistakes that a checked machine looks for, each with a check of its own, and what it throws.
// docs/checked-mode.md shows a program that each one finds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "simulator/base/error.h"

namespace lanescope {

enum class Check {
  kDeadLane,     ///< Reads a lane that was off when the operand was computed.
  kBeyondWidth,  ///< Opens a block with lanes on that the machine does not have.
  kBounds,       ///< Addresses an element outside its memory.
  kUnwritten,    ///< Reads memory that was never written.
  kConflict,     ///< Two lanes of one instruction store to one element.
  kShiftCount,   ///< Shifts by a count that is not from 0 to 31.
  kConversion,   ///< Converts a float that no integer of the result's type stands for.
  kDivision,     ///< Divides integers where there is no quotient.
  kLaneIndex,    ///< Addresses a lane outside the vector.
  kNan,          ///< Makes not-a-number of numbers.
  kNoLane,       ///< Reduces no lanes.
  kWidth,        ///< Has other results at another width: found by comparing runs.
  kOperand,      ///< For instructions from outside the set: what their own struct calls suspicious.
};

/// Whether what the check looks for has a defined result all the same, which a program may mean.
constexpr bool has_defined_result(Check check) { return check > Check::kUnwritten; }

std::string_view to_string(Check check);

/// A set of checks.
class CheckSet {
 public:
  constexpr CheckSet() = default;
  constexpr CheckSet(Check check) : bits_(std::uint32_t{1} << static_cast<int>(check)) {}
  static constexpr CheckSet all() { return CheckSet(~std::uint32_t{0}); }

  constexpr bool has(Check check) const { return (bits_ & CheckSet(check).bits_) != 0; }
  constexpr CheckSet with(CheckSet other) const { return CheckSet(bits_ | other.bits_); }
  constexpr CheckSet without(CheckSet other) const { return CheckSet(bits_ & ~other.bits_); }

 private:
  constexpr explicit CheckSet(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = 0;
};

/// What a struct says of operands for which its result is defined, but hardly meant; see checks.h.
struct Suspicion {
  Check check;
  std::string_view reason;
};

/// A program did what a check looks for:
///
///   kernels/mine.h:42: shl, lane 3: the count is not from 0 to 31, in shl(1, 32)
class FailedCheck : public CheckError {
 public:
  FailedCheck(Check check, const std::string& text) : CheckError(text), check_(check) {}
  Check check() const { return check_; }

 private:
  Check check_;
};

}  // namespace lanescope
