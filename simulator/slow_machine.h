// SPDX-License-Identifier: MIT
// The slow machine, for the modes that are not to run fast: checked and tracing. It is compiled for
// one number of lanes, without effort. It charges each instruction as it issues it, or tells of it,
// without lists or logs, and so is an oracle for the counts of the fast machine.
#pragma once

#include <cstdint>
#include <source_location>
#include <vector>

#include "simulator/base/error.h"
#include "simulator/checks.h"
#include "simulator/machine.h"
#include "simulator/observer.h"

namespace lanescope {
namespace detail {

/// What the instructions of a slow machine act on, whatever its lanes.
struct SlowState {
  Tally tally;
  CheckSet checks;  ///< None if the machine is tracing.
  Observer* observer;
  StoredElements stored;       ///< By the instruction that is being checked.
  std::vector<Touch> touches;  ///< Of the instruction that is being told of.

  Width width() const { return {tally.width()}; }
  bool checked() const { return observer == nullptr; }
};

/// What an instruction is issued with.
struct IssueTerms {
  bool overhead = false;
  CheckSet allowed = {};  ///< What it is meant to do.
};

/// The terms that allow what the check looks for, too. Throws CheckError if that has no defined
/// result.
IssueTerms allowing(const IssueTerms& terms, Check check);

/// A block as it was opened, but for its mask.
struct OpenedBlock {
  std::size_t stage;
  std::source_location at;
};

/// Charges a checked instruction, or tells the observer of a traced one, with what is in
/// `state.touches`.
void charge_or_tell(SlowState& state, const InstructionInfo& info, const OpenedBlock& block,
                    std::uint64_t active, bool overhead, const std::source_location& at);

/// Checks the operands and the accesses of an instruction, and keeps what it touches.
template <class Op, int L, class... Operands>
void examine(SlowState& state, CheckSet checks, Mask<L> active, const std::source_location& at,
             const Operands&... operands) {
  if (checks.has(Check::kDeadLane)) {
    [[maybe_unused]] int position = 0;
    ((check_operand(Op::kInfo, lanes_read<Op>(position, active, state.width(), plain(operands)...),
                    position, operands, at),
      ++position),
     ...);
  }
  check_suspicion<Op>(checks, active, state.width(), at, plain(operands)...);
  state.touches.clear();
  std::string_view memory_name;
  const auto visit = [&]<class T>(int lane, const Memory<T>& memory, std::int64_t element,
                                  Access access) {
    if (state.checked()) {
      check_access(checks, Op::kInfo, lane, memory, element, access, state.stored, at);
      memory_name = memory.name;
    } else {
      state.touches.push_back(
          {lane, static_cast<std::uint64_t>(element) * sizeof(T), sizeof(T), access});
    }
  };
  if constexpr (requires { Op::touch(active, visit, plain(operands)...); }) {
    state.stored.clear();
    Op::touch(active, visit, plain(operands)...);
    if (checks.has(Check::kConflict)) state.stored.require_distinct(Op::kInfo, memory_name, at);
  } else {
    static_assert(!(IsMemory<Operands>::value || ...),
                  "an instruction on memory needs touch(), so that its accesses can be checked");
  }
}

/// Not inlined: a slow machine is for finding mistakes, and is built more often than it runs.
template <class Op, int L, class... Operands>
[[gnu::noinline]] auto issue_slowly(SlowState& state, const OpenedBlock& block, Mask<L> active,
                                    const IssueTerms& terms, const std::source_location& at,
                                    const Operands&... operands) {
  const CheckSet checks = state.checks.without(terms.allowed);
  examine<Op>(state, checks, active, at, operands...);
  charge_or_tell(state, Op::kInfo, block, active.bits(), terms.overhead, at);
  using R = decltype(execute<Op>(active, state.width(), plain(operands)...));
  if constexpr (std::is_void_v<R>) {
    execute<Op>(active, state.width(), plain(operands)...);
  } else {
    const R plain_result = execute<Op>(active, state.width(), plain(operands)...);
    if (checks.has(Check::kNan))
      check_born_nan<Op>(active, state.width(), plain_result, at, plain(operands)...);
    auto result = as_checked(plain_result);
    if (state.checked())
      define_lanes(result, defined_lanes<Op>(active, state.width(), operands...));
    return result;
  }
}

}  // namespace detail

inline namespace LANESCOPE_HOST {

/// Code under one mask.
template <int L>
class SlowBlock {
 public:
  SlowBlock(detail::SlowState& state, const detail::OpenedBlock& opened, Mask<L> active)
      : state_(state), opened_(opened), active_(active) {}
  SlowBlock(const SlowBlock&) = delete;
  SlowBlock& operator=(const SlowBlock&) = delete;

  Mask<L> active() const { return active_; }

  /// Checks, charges and executes Op; see Instruction.
  template <class Op, class... Operands>
  auto issue(const std::source_location& at, const Operands&... operands) {
    return detail::issue_slowly<Op>(state_, opened_, active_, {}, at, operands...);
  }

  /// The same block for instructions that are issued on other terms.
  struct OnTerms {
    SlowBlock& block;
    detail::IssueTerms terms;
    Mask<L> active() const { return block.active_; }
    template <class Op, class... Operands>
    auto issue(const std::source_location& at, const Operands&... operands) {
      return detail::issue_slowly<Op>(block.state_, block.opened_, block.active_, terms, at,
                                      operands...);
    }
    OnTerms allowing(Check check) const { return {block, detail::allowing(terms, check)}; }
  };
  /// For instructions that the kernel's baseline does not have to execute.
  OnTerms overhead() { return {*this, {true, {}}}; }
  /// For instructions that are meant to do what the check looks for. Requires that this has a
  /// defined result: nothing allows to read dead lanes or to leave a memory.
  OnTerms allowing(Check check) { return {*this, detail::allowing({}, check)}; }

 private:
  detail::SlowState& state_;
  detail::OpenedBlock opened_;
  Mask<L> active_;
};

/// A place in a program that executes blocks of one stage.
template <int L>
class SlowSite {
 public:
  SlowSite(detail::SlowState& state, std::size_t stage) : state_(state), stage_(stage) {
    if (stage >= state.tally.stage_count()) detail::fail_stage(stage, state.tally.stage_count());
  }

  /// Opens a block of instructions that run under `active`. A checked machine throws FailedCheck if
  /// a lane beyond the width is.
  SlowBlock<L> on(Mask<L> active, std::source_location at = std::source_location::current()) {
    if (state_.checks.has(Check::kBeyondWidth) &&
        (active.bits() & ~low_bits(state_.width().lanes)) != 0)
      detail::fail_beyond_width(active.bits(), state_.width(), at);
    return {state_, {stage_, at}, active};
  }

 private:
  detail::SlowState& state_;
  std::size_t stage_;
};

/// A vector machine of L lanes, of which a run uses the first `width`, that checks what a program
/// does, or shows it to an observer. Programs use it as they use Machine. Not thread-safe.
template <int L>
requires LaneCount<L>
class SlowMachine {
 public:
  static constexpr int kLanes = L;
  static constexpr bool kCounted = true;

  using Float = CheckedVec<float, L>;
  using Int = CheckedVec<std::int32_t, L>;
  using Uint = CheckedVec<std::uint32_t, L>;
  using Lanes = Mask<L>;
  using Site = SlowSite<L>;

  /// Throws CheckError unless 1 <= width <= L. Requires a slow mode; a tracing machine needs an
  /// observer, which must outlive it, and others have none.
  SlowMachine(int width, std::size_t stage_count, Mode mode, Observer* observer = nullptr)
      : state_{Tally(detail::checked_width(width, L).lanes, stage_count),
               mode == Mode::kChecked ? CheckSet::all() : CheckSet(),
               observer,
               {},
               {}} {
    LANESCOPE_CHECK(is_slow(mode), "{} is not a mode of a slow machine", to_string(mode));
    LANESCOPE_CHECK((observer != nullptr) == (mode == Mode::kTracing),
                    "a machine has an observer if and only if it is tracing");
    host::require_same_host();
  }

  int width() const { return state_.width().lanes; }
  Lanes all() const { return Lanes::first_n(width()); }
  Lanes first_n(int n) const { return Lanes::first_n(n < width() ? n : width()); }

  /// A place that executes blocks of a stage. Throws CheckError unless stage < stage_count.
  Site site(std::size_t stage) { return Site(state_, stage); }

  void begin_batch() {
    if (state_.observer) state_.observer->batch_begins();
  }

  bool checks() const { return state_.checked(); }
  /// Leaves checks out from now on; dead lanes are poison all the same. Without that of bounds, or
  /// of lanes beyond the width, the program must have memory there.
  void leave_out(CheckSet checks) { state_.checks = state_.checks.without(checks); }

  template <class T>
  static const Vec<T, L>& look(const CheckedVec<T, L>& v) {
    return v.vec;
  }

  /// What has been counted; without stages if the machine is tracing. Throws CheckError if two
  /// instructions have one mnemonic.
  Counts counts() const { return state_.checked() ? state_.tally.counts() : Counts(); }

 private:
  detail::SlowState state_;
};

}  // namespace LANESCOPE_HOST
}  // namespace lanescope
