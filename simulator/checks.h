// SPDX-License-Identifier: MIT
// What a checked machine does around an instruction: no active lane may read a dead lane's value,
// address outside its memory, or read memory that was never written. Included by issue.h.
#pragma once

#include <limits>

#include "simulator/issue.h"
#include "simulator/memory.h"

namespace lanescope::detail {

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
                              std::uint32_t size, std::string_view memory,
                              const std::source_location& at);
[[noreturn]] void fail_unwritten(const InstructionInfo& info, int lane, std::int64_t element,
                                 std::string_view memory, const std::source_location& at);

/// Whether an operand is one whose lanes the dead lanes of the result keep.
template <class Op>
constexpr bool is_rest(int position) {
  if constexpr (requires { Op::kRest; })
    return position >= Op::kRest;
  else
    return false;
}

/// The lanes in which an instruction reads an operand: the active ones, unless its `reads()` knows
/// better.
template <class Op, int W, class... Operands>
Mask<W> lanes_read(int position, Mask<W> active, const Operands&... operands) {
  if (is_rest<Op>(position)) return Mask<W>::none();
  if constexpr (requires { Op::reads(position, active, operands...); })
    return Op::reads(position, active, operands...);
  else
    return active;
}

template <class Op, int W, class Operand>
void check_operand(Mask<W> read, int position, const Operand& operand,
                   const std::source_location& at) {
  if constexpr (kIsChecked<Operand>) {
    const Mask<W> dead = read & ~operand.defined;
    if (dead.any()) fail_dead_lane(Op::kInfo, position, std::countr_zero(dead.bits()), at);
  }
}

/// Checks the elements that a memory instruction touches. Such an instruction has
/// `touch(active, f, operands...)`, which calls f(lane, memory, element, is_store) for each.
template <class Op, int W, class... Operands>
void check_memory(Mask<W> active, const std::source_location& at, const Operands&... operands) {
  const auto check = [&](int lane, const auto& memory, std::int64_t element, bool is_store) {
    if (element < 0 || element >= std::int64_t{memory.size})
      fail_bounds(Op::kInfo, lane, element, memory.size, memory.name, at);
    if (!memory.written) return;
    if (is_store)
      memory.written[element] = 1;
    else if (!memory.written[element])
      fail_unwritten(Op::kInfo, lane, element, memory.name, at);
  };
  if constexpr (requires { Op::touch(active, check, operands...); })
    Op::touch(active, check, operands...);
  else
    static_assert(!(IsMemory<Operands>::value || ...),
                  "an instruction on memory needs touch(), so that its accesses can be checked");
}

/// The lanes that hold a value in every operand that a merging instruction keeps.
template <class Op, int W, class... Operands>
Mask<W> kept_lanes(const Operands&... operands) {
  Mask<W> kept = Mask<W>::all();
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
  return merges ? kept : Mask<W>::none();
}

/// The lanes of a result that hold a value: the active ones and those kept; an instruction that
/// moves data between lanes can say otherwise by `defined()`.
template <class Op, int W, class... Operands>
Mask<W> defined_lanes(Mask<W> active, const Operands&... operands) {
  if constexpr (requires { Op::defined(active, plain(operands)...); })
    return Op::defined(active, plain(operands)...);
  else
    return active | kept_lanes<Op, W>(operands...);
}

template <class T, int W>
CheckedVec<T, W> poisoned(Vec<T, W> vec, Mask<W> defined) {
  for (int i = 0; i < W; ++i)
    if (!defined[i]) vec.set(i, poison<T>());
  return {vec, defined};
}

/// A result as the checked program sees it; pairs of vectors element by element.
template <class R, int W>
auto checked_result(const R& result, Mask<W> defined) {
  if constexpr (kIsVec<R>)
    return poisoned(result, defined);
  else if constexpr (requires {
                       result.first;
                       result.second;
                     })
    return std::pair(poisoned(result.first, defined), poisoned(result.second, defined));
  else
    return result;
}

/// Not inlined: a checked machine is for finding mistakes, and need not be fast to be built often.
template <class Op, int W, class... Operands>
[[gnu::noinline]] auto execute_checked(Mask<W> active, const std::source_location& at,
                                       const Operands&... operands) {
  [[maybe_unused]] int position = 0;
  ((check_operand<Op>(lanes_read<Op>(position, active, plain(operands)...), position, operands, at),
    ++position),
   ...);
  check_memory<Op>(active, at, plain(operands)...);
  using R = decltype(execute<Op, W>(active, plain(operands)...));
  if constexpr (std::is_void_v<R>)
    execute<Op, W>(active, plain(operands)...);
  else
    return checked_result(execute<Op, W>(active, plain(operands)...),
                          defined_lanes<Op>(active, operands...));
}

}  // namespace lanescope::detail
