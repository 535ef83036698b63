// SPDX-License-Identifier: MIT
// What a checked machine does around an instruction: no active lane may read a dead lane's value,
// address outside its memory, read memory that was never written, or store where another lane of
// the same instruction stores. What a struct can say to that end, each optional:
//
//   static constexpr int kRest = n;         operands n and up are kept by dead lanes, see execute.h
//   reads(position, active[, width], operands...)   the lanes in which an operand is read, if not
//                                           the active ones
//   defined(active[, width], operands...)   the lanes of the result that hold a value, if not the
//                                           active ones and those kept
//   touch(active, f, operands...)           calls f(lane, memory, element, access) for each element
//                                           that it touches; compulsory for operands in memory
#pragma once

#include <limits>
#include <source_location>
#include <utility>
#include <vector>

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

[[noreturn]] void fail_dead_lane(const InstructionInfo& info, int operand, int lane,
                                 const std::source_location& at);
[[noreturn]] void fail_bounds(const InstructionInfo& info, int lane, std::int64_t element,
                              std::size_t size, std::string_view memory,
                              const std::source_location& at);
[[noreturn]] void fail_unwritten(const InstructionInfo& info, int lane, std::int64_t element,
                                 std::string_view memory, const std::source_location& at);
/// Throws CheckError: lanes of a block are on that are beyond the width.
[[noreturn]] void fail_beyond_width(std::uint64_t active, Width width,
                                    const std::source_location& at);

/// The elements that the lanes of one instruction store to.
class StoredElements {
 public:
  void clear() { stored_.clear(); }
  void add(int lane, std::int64_t element) { stored_.push_back({element, lane}); }
  /// Throws CheckError if two lanes store to one element.
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
void check_access(const InstructionInfo& info, int lane, const Memory<T>& memory,
                  std::int64_t element, Access access, StoredElements& stored,
                  const std::source_location& at) {
  if (element < 0 || static_cast<std::uint64_t>(element) >= memory.size)
    fail_bounds(info, lane, element, memory.size, memory.name, at);
  if (access == Access::kStore) stored.add(lane, element);
  if (!memory.written) return;
  if (access != Access::kStore && !memory.written[element])
    fail_unwritten(info, lane, element, memory.name, at);
  memory.written[element] = 1;
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
