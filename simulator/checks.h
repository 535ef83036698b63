// SPDX-License-Identifier: MIT
// What a checked machine does around an instruction: it looks for each of the mistakes of check.h.
// What a struct can say to that end, each optional:
//
//   static constexpr int kRest = n;         operands n and up are kept by dead lanes, see execute.h
//   reads(position, active[, width], operands...)   the lanes in which an operand is read, if not
//                                           the active ones
//   defined(active[, width], operands...)   the lanes of the result that hold a value, if not the
//                                           active ones and those kept
//   touch(active, f, operands...)           calls f(lane, memory, element, access) for each element
//                                           that it touches; compulsory for operands in memory
//   suspicious([width, ]operands...)        whether a lane with these operands (vectors by their
//                                           lane, scalars as they are) does what is defined, but
//                                           hardly meant, which is
//   static constexpr Suspicion kSuspicion{check, reason};
#pragma once

#include <cmath>
#include <limits>
#include <source_location>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "simulator/check.h"
#include "simulator/execute.h"
#include "simulator/memory.h"

namespace lanescope {
inline namespace LANESCOPE_HOST {

/// A vector of a slow machine. On a checked one `defined` is which lanes hold a value, and the
/// others are poison.
template <class T, int L>
struct CheckedVec {
  using Element = T;
  Vec<T, L> vec;
  Mask<L> defined = Mask<L>::none();
};

}  // namespace LANESCOPE_HOST

namespace detail {

template <class T>
struct IsChecked : std::false_type {};
template <class T, int L>
struct IsChecked<CheckedVec<T, L>> : std::true_type {};
template <class T>
inline constexpr bool kIsChecked = IsChecked<std::remove_cvref_t<T>>::value;

template <class T>
struct IsMemory : std::false_type {};
template <class T>
struct IsMemory<Memory<T>> : std::true_type {};

template <class Operand>
const auto& plain(const Operand& operand) {
  if constexpr (kIsChecked<Operand>)
    return operand.vec;
  else
    return operand;
}

/// What dead lanes of a checked machine hold.
template <class T>
constexpr T poison() {
  if constexpr (std::is_floating_point_v<T>)
    return std::numeric_limits<T>::quiet_NaN();
  else
    return static_cast<T>(0x7badbad1);
}

/// What one lane holds.
using LaneValue = std::variant<float, std::int32_t, std::uint32_t>;
/// A value as people read it: of not-a-number no sign, of whole floats every digit.
std::string to_text(const LaneValue& value);

[[noreturn]] void fail_dead_lane(const InstructionInfo& info, int operand, int lane,
                                 const std::source_location& at);
[[noreturn]] void fail_bounds(const InstructionInfo& info, int lane, std::int64_t element,
                              std::size_t size, std::string_view memory,
                              const std::source_location& at);
[[noreturn]] void fail_unwritten(const InstructionInfo& info, int lane, std::int64_t element,
                                 std::string_view memory, const std::source_location& at);
[[noreturn]] void fail_suspicious(const InstructionInfo& info, const Suspicion& suspicion, int lane,
                                  std::span<const LaneValue> operands,
                                  const std::source_location& at);
/// A reduction has no lanes, or makes not-a-number of all of them.
[[noreturn]] void fail_reduction(const InstructionInfo& info, const Suspicion& suspicion,
                                 const std::source_location& at);
/// Lanes of a block are on that are beyond the width.
[[noreturn]] void fail_beyond_width(std::uint64_t active, Width width,
                                    const std::source_location& at);

/// The elements that the lanes of one instruction store to.
class StoredElements {
 public:
  void clear() { stored_.clear(); }
  void add(int lane, std::int64_t element) { stored_.push_back({element, lane}); }
  /// Throws FailedCheck if two lanes store to one element.
  void require_distinct(const InstructionInfo& info, std::string_view memory,
                        const std::source_location& at);

 private:
  std::vector<std::pair<std::int64_t, int>> stored_;
};

/// Whether an operand is one whose lanes the dead lanes of the result keep.
template <class Op>
constexpr bool is_rest(int position) {
  if constexpr (requires { Op::kRest; })
    return position >= Op::kRest;
  else
    return false;
}

template <class Op, int L, class... Operands>
Mask<L> lanes_read(int position, Mask<L> active, [[maybe_unused]] Width width,
                   const Operands&... operands) {
  if (is_rest<Op>(position)) return Mask<L>::none();
  if constexpr (requires { Op::reads(position, active, operands...); })
    return Op::reads(position, active, operands...);
  else if constexpr (requires { Op::reads(position, active, width, operands...); })
    return Op::reads(position, active, width, operands...);
  else
    return active;
}

template <int L, class Operand>
void check_operand(const InstructionInfo& info, Mask<L> read, int position, const Operand& operand,
                   const std::source_location& at) {
  if constexpr (kIsChecked<Operand>) {
    const std::uint64_t dead = read.bits() & ~operand.defined.bits();
    if (dead != 0) fail_dead_lane(info, position, std::countr_zero(dead), at);
  }
}

/// Checks an access to an element, and keeps what it stores to.
template <class T>
void check_access(CheckSet checks, const InstructionInfo& info, int lane, const Memory<T>& memory,
                  std::int64_t element, Access access, StoredElements& stored,
                  const std::source_location& at) {
  if (element < 0 || static_cast<std::uint64_t>(element) >= memory.size) {
    if (!checks.has(Check::kBounds)) return;
    fail_bounds(info, lane, element, memory.size, memory.name, at);
  }
  if (access == Access::kStore) stored.add(lane, element);
  if (!memory.written) return;
  if (access != Access::kStore && !memory.written[element] && checks.has(Check::kUnwritten))
    fail_unwritten(info, lane, element, memory.name, at);
  memory.written[element] = 1;
}

/// An operand as one lane has it.
template <class Operand>
auto in_lane(const Operand& operand, [[maybe_unused]] int lane) {
  if constexpr (kIsVec<Operand>)
    return operand[lane];
  else
    return operand;
}

/// What of an operand can be shown: masks and memory cannot.
template <class Operand>
void show_lane(std::vector<LaneValue>& shown, const Operand& operand, int lane) {
  using T = decltype(in_lane(operand, lane));
  if constexpr (std::is_floating_point_v<T>)
    shown.push_back(static_cast<float>(in_lane(operand, lane)));
  else if constexpr (std::is_unsigned_v<T>)
    shown.push_back(static_cast<std::uint32_t>(in_lane(operand, lane)));
  else if constexpr (std::is_integral_v<T>)
    shown.push_back(static_cast<std::int32_t>(in_lane(operand, lane)));
}

template <class... Operands>
[[noreturn]] void fail_in_lane(const InstructionInfo& info, const Suspicion& suspicion, int lane,
                               const std::source_location& at, const Operands&... operands) {
  std::vector<LaneValue> shown;
  (show_lane(shown, operands, lane), ...);
  fail_suspicious(info, suspicion, lane, shown, at);
}

template <class Op, class... Operands>
bool is_suspicious(int lane, [[maybe_unused]] Width width, const Operands&... operands) {
  if constexpr (requires { Op::suspicious(in_lane(operands, lane)...); })
    return Op::suspicious(in_lane(operands, lane)...);
  else if constexpr (requires { Op::suspicious(width, in_lane(operands, lane)...); })
    return Op::suspicious(width, in_lane(operands, lane)...);
  else
    return false;
}

/// Whether a struct says what is suspicious.
template <class Op>
concept SaysSuspicion = requires {
  Op::kSuspicion;
};

/// What the struct of an instruction calls suspicious, in active lanes.
template <class Op, int L, class... Operands>
void check_suspicion(CheckSet checks, Mask<L> active, Width width, const std::source_location& at,
                     const Operands&... operands) {
  if constexpr (SaysSuspicion<Op>) {
    if (!checks.has(Op::kSuspicion.check)) return;
    for_each_lane(active, [&](int lane) {
      if (is_suspicious<Op>(lane, width, operands...))
        fail_in_lane(Op::kInfo, Op::kSuspicion, lane, at, operands...);
    });
  }
  if (Op::kInfo.instruction_class == InstructionClass::kReduce && checks.has(Check::kNoLane) &&
      !active.any())
    fail_reduction(Op::kInfo, {Check::kNoLane, "no lane is active"}, at);
}

/// The lanes in which an operand is not-a-number, of a scalar all or none.
template <int L, class Operand>
Mask<L> nan_lanes([[maybe_unused]] const Operand& operand) {
  std::uint64_t bits = 0;
  if constexpr (std::is_same_v<Operand, Vec<float, L>>) {
    for (int i = 0; i < L; ++i) bits |= std::uint64_t{std::isnan(operand[i])} << i;
  } else if constexpr (std::is_floating_point_v<Operand>) {
    if (std::isnan(operand)) return Mask<L>::all();
  }
  return Mask<L>::from_bits(bits);
}

/// The lanes in which not-a-number may come from an operand: those that have it themselves or, if
/// the instruction is not lane by lane, all if it reads it anywhere.
template <class Op, int L, class... Operands>
Mask<L> lanes_given_nan(Mask<L> active, Width width, const Operands&... operands) {
  Mask<L> given = Mask<L>::none();
  [[maybe_unused]] int position = 0;
  if constexpr (
      requires { Op::apply(active, operands...); } ||
      requires { Op::apply(active, width, operands...); }) {
    ((given =
          given | (nan_lanes<L>(operands) & lanes_read<Op>(position, active, width, operands...)),
      ++position),
     ...);
    return given.any() ? Mask<L>::all() : given;
  } else {
    ((given = given | nan_lanes<L>(operands)), ...);
    return given;
  }
}

/// That not-a-number is not born in an active lane; memory may hold it.
template <class Op, int L, class R, class... Operands>
void check_born_nan([[maybe_unused]] Mask<L> active, [[maybe_unused]] Width width,
                    [[maybe_unused]] const R& result,
                    [[maybe_unused]] const std::source_location& at, const Operands&... operands) {
  constexpr Suspicion kBorn{Check::kNan, "the result is not a number"};
  if constexpr ((IsMemory<Operands>::value || ...)) {
    return;
  } else if constexpr (std::is_same_v<R, Vec<float, L>>) {
    const Mask<L> found = active & nan_lanes<L>(result);
    if (!found.any()) return;
    const Mask<L> born = found & ~lanes_given_nan<Op>(active, width, operands...);
    if (born.any()) fail_in_lane(Op::kInfo, kBorn, std::countr_zero(born.bits()), at, operands...);
  } else if constexpr (std::is_floating_point_v<R>) {
    if (std::isnan(result) && !lanes_given_nan<Op>(active, width, operands...).any())
      fail_reduction(Op::kInfo, kBorn, at);
  }
}

/// The lanes that hold a value in every operand that a merging instruction keeps.
template <class Op, int L, class... Operands>
Mask<L> kept_lanes(const Operands&... operands) {
  Mask<L> kept = Mask<L>::all();
  bool merges = false;
  int position = 0;
  [[maybe_unused]] const auto look = [&](const auto& operand) {
    if constexpr (kIsChecked<decltype(operand)>) {
      if (is_rest<Op>(position)) {
        kept = kept & operand.defined;
        merges = true;
      }
    }
    ++position;
  };
  (look(operands), ...);
  return merges ? kept : Mask<L>::none();
}

/// The lanes of a result that hold a value.
template <class Op, int L, class... Operands>
Mask<L> defined_lanes(Mask<L> active, [[maybe_unused]] Width width, const Operands&... operands) {
  if constexpr (requires { Op::defined(active, plain(operands)...); })
    return Op::defined(active, plain(operands)...);
  else if constexpr (requires { Op::defined(active, width, plain(operands)...); })
    return Op::defined(active, width, plain(operands)...);
  else
    return active | kept_lanes<Op, L>(operands...);
}

template <class T, int L>
void poison_dead_lanes(CheckedVec<T, L>& v, Mask<L> defined) {
  v.defined = defined;
  const auto poisoned = Vec<T, L>::broadcast(poison<T>());
  for (int c = 0; c < kChunks<L>; ++c)
    v.vec.chunk[c] = host::blend(defined.chunk(c), v.vec.chunk[c], poisoned.chunk[c]);
}

/// A result as the program of a slow machine sees it; pairs of vectors element by element.
template <class R>
LANESCOPE_INLINE auto as_checked(const R& result) {
  if constexpr (kIsVec<R>) {
    return CheckedVec<typename R::Element, R::kLanes>{result};
  } else if constexpr (requires {
                         result.first;
                         result.second;
                       }) {
    return std::pair(as_checked(result.first), as_checked(result.second));
  } else {
    return result;
  }
}

/// Poisons the dead lanes of a result.
template <class R, int L>
void define_lanes([[maybe_unused]] R& result, [[maybe_unused]] Mask<L> defined) {
  if constexpr (kIsChecked<R>) {
    poison_dead_lanes(result, defined);
  } else if constexpr (requires {
                         result.first;
                         result.second;
                       }) {
    define_lanes(result.first, defined);
    define_lanes(result.second, defined);
  }
}

}  // namespace detail
}  // namespace lanescope
