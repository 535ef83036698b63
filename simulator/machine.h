// SPDX-License-Identifier: MIT
// The fast machine. A program names a stage at a site, opens a block there under a mask, and issues
// instructions in the block:
//
//   Machine<16, Mode::kCounting> vm(12, stage_count);   // 16 lanes, of which a run uses 12
//   auto test = vm.site(kTest);             // outside the loop
//   while (...) {
//     auto on = test.on(active);            // until the end of the scope
//     const auto e = sub(on, mul(on, ax, by), mul(on, ay, bx));
//   }
//
// Counting happens when a block ends. A block keeps a list of what it has issued, and a signature
// of the list; in straight-line code the compiler folds both to constants, and all that runs is:
// compare the signature with the site's, and write the mask to the site's log. When the signature
// differs (the first execution, another path through a block with branches) what was logged goes to
// the Tally, and the log begins again with the new list, so counts are exact always.
//
// A site is a local variable, and its address must not escape: what an output store may alias
// would be loaded again and again.
#pragma once

#include <cstdint>
#include <source_location>

#include "simulator/base/error.h"
#include "simulator/check.h"
#include "simulator/execute.h"
#include "simulator/mode.h"
#include "simulator/tally.h"

namespace lanescope {
namespace detail {

/// Throws CheckError: a machine of `lanes` lanes cannot be `width` wide.
[[noreturn, gnu::cold]] void fail_width(int width, int lanes);
/// Throws CheckError: a site of a stage that the program does not have.
[[noreturn, gnu::cold]] void fail_stage(std::size_t stage, std::size_t stage_count);

inline Width checked_width(int width, int lanes) {
  if (width < 1 || width > lanes) fail_width(width, lanes);
  return {width};
}

/// A 64-bit hash of a number, for signatures.
constexpr std::uint64_t hash_number(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return (x ^ (x >> 31)) | 1;
}

/// What one issue of Op adds to the signature of a block. A sum, so that it depends on what was
/// issued and not on the order. An instruction from outside the set is known by the address of its
/// descriptor, which no other has.
template <class Op, bool kOverhead>
LANESCOPE_INLINE std::uint64_t signature_of() {
  constexpr std::size_t kIndex = kInstructionIndex<Op>;
  if constexpr (kIndex < InstructionSet::kSize) {
    constexpr std::uint64_t kKind = hash_number(2 * kIndex + kOverhead + 1);
    return kKind;
  } else {
    return hash_number(reinterpret_cast<std::uintptr_t>(&Op::kInfo) + kOverhead);
  }
}

// The slow paths are noexcept (out of memory ends the program): an exception's way out of the hot
// loop would keep in memory what belongs in registers.

/// Begins a list of a site; its log, null at first, has masks before `next`. Returns the log.
template <class Word>
[[gnu::noinline, gnu::cold]] SiteLog* begin_list(Tally& tally, std::size_t stage, SiteLog* log,
                                                 const Word* next, const IssueList& list) noexcept {
  if (log) {
    log->sum_up(next);
    tally.take(*log);
  } else {
    log = &tally.open(stage);
  }
  log->list = list;
  return log;
}

/// Sums up a full log. Returns where it begins.
template <class Word>
[[gnu::noinline, gnu::cold]] Word* sum_up(SiteLog& log) noexcept {
  log.sum_up(log.end<Word>());
  return log.begin<Word>();
}

template <class Word>
[[gnu::noinline, gnu::cold]] void end_site(Tally& tally, SiteLog& log, const Word* next) noexcept {
  log.sum_up(next);
  tally.take(log);
  tally.close(log);
}

[[gnu::noinline, gnu::cold]] inline void charge(Tally& tally, std::size_t stage, Issued issued,
                                                std::uint64_t active) noexcept {
  tally.charge(stage, issued, active);
}

}  // namespace detail

inline namespace LANESCOPE_HOST {

template <int L, Mode M>
class Block;

/// A place in a program that executes blocks of one stage. Local, outside the loop.
template <int L, Mode M>
class Site {
 public:
  LANESCOPE_INLINE Site(Tally& tally, std::size_t stage) : tally_(tally), stage_(stage) {
    if (stage >= tally.stage_count()) detail::fail_stage(stage, tally.stage_count());
  }
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;
  LANESCOPE_INLINE ~Site() {
    if (log_) detail::end_site(tally_, *log_, next_);
  }

  /// Opens a block of instructions that run under `active`. Requires that no lane from the
  /// machine's width on is active.
  LANESCOPE_INLINE Block<L, M> on(Mask<L> active) { return Block<L, M>(*this, active); }

 private:
  friend class Block<L, M>;

  Tally& tally_;
  std::size_t stage_;
  std::uint64_t signature_ = 0;  ///< Of the list that is being logged; 0 is none.
  SiteLog* log_ = nullptr;
  LoggedMask<L>* next_ = nullptr;  ///< Where the next mask goes in the log, and
  LoggedMask<L>* end_ = nullptr;   ///< where the log is full.
};

/// Code under one mask. Instructions issued in it are charged when it ends.
template <int L, Mode M>
class Block {
 public:
  LANESCOPE_INLINE Block(Site<L, M>& site, Mask<L> active) : site_(site), active_(active) {}
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  LANESCOPE_INLINE ~Block() { end(); }

  LANESCOPE_INLINE Mask<L> active() const { return active_; }

  /// Charges and executes Op; see Instruction.
  template <class Op, class... Operands>
  LANESCOPE_INLINE auto issue(const std::source_location&, const Operands&... operands) {
    append<Op, false>();
    return detail::execute<Op>(active_, width(), operands...);
  }

  /// The same block for instructions that the kernel's baseline does not have to execute.
  struct Overhead {
    Block& block;
    LANESCOPE_INLINE Mask<L> active() const { return block.active_; }
    template <class Op, class... Operands>
    LANESCOPE_INLINE auto issue(const std::source_location&, const Operands&... operands) {
      block.template append<Op, true>();
      return detail::execute<Op>(block.active_, block.width(), operands...);
    }
    LANESCOPE_INLINE Overhead& allowing(Check) { return *this; }
  };
  LANESCOPE_INLINE Overhead overhead() { return {*this}; }
  /// The same block: what a checked machine is told, see SlowBlock.
  LANESCOPE_INLINE Block& allowing(Check) { return *this; }

 private:
  LANESCOPE_INLINE Width width() const { return {site_.tally_.width()}; }

  template <class Op, bool kOverhead>
  LANESCOPE_INLINE void append() {
    if constexpr (M == Mode::kCounting) {
      constexpr std::size_t kIndex = kInstructionIndex<Op>;
      if constexpr (kIndex < InstructionSet::kSize) {
        constexpr int kShift = 16 * (kIndex % 4);
        std::uint64_t& word = (kOverhead ? overhead_ : baseline_)[kIndex / 4];
        if ((word >> kShift & IssueList::kMostTimes) == IssueList::kMostTimes) [[unlikely]]
          return detail::charge(site_.tally_, site_.stage_, {&Op::kInfo, kOverhead},
                                active_.bits());
        word += std::uint64_t{1} << kShift;
      } else {
        if (foreign_count_ == IssueList::kForeign) [[unlikely]]
          return detail::charge(site_.tally_, site_.stage_, {&Op::kInfo, kOverhead},
                                active_.bits());
        foreign_[foreign_count_] = {&Op::kInfo, kOverhead};
        ++foreign_count_;
      }
      signature_ += detail::signature_of<Op, kOverhead>();
    }
  }

  LANESCOPE_INLINE void end() {
    if constexpr (M == Mode::kCounting) {
      if (signature_ == 0) return;
      if (site_.signature_ != signature_) [[unlikely]]
        switch_list();
      *site_.next_++ = static_cast<LoggedMask<L>>(active_.bits());
      if (site_.next_ == site_.end_) [[unlikely]]
        site_.next_ = detail::sum_up<LoggedMask<L>>(*site_.log_);
    }
  }

  LANESCOPE_INLINE void switch_list() {
    IssueList copy;
    host::unroll<IssueList::kWords>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      copy.baseline[i] = baseline_[i];
      copy.overhead[i] = overhead_[i];
    });
    copy.foreign_count = foreign_count_;
    host::unroll<IssueList::kForeign>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      if (i < foreign_count_) copy.foreign[i] = foreign_[i];
    });
    site_.log_ = detail::begin_list(site_.tally_, site_.stage_, site_.log_, site_.next_, copy);
    site_.next_ = site_.log_->template begin<LoggedMask<L>>();
    site_.end_ = site_.log_->template end<LoggedMask<L>>();
    site_.signature_ = signature_;
  }

  Site<L, M>& site_;
  Mask<L> active_;
  std::uint64_t signature_ = 0;
  // The list (see IssueList), in members of its own: an aggregate that is copied stays in memory.
  std::uint64_t baseline_[IssueList::kWords] = {};
  std::uint64_t overhead_[IssueList::kWords] = {};
  Issued foreign_[IssueList::kForeign];
  int foreign_count_ = 0;
};

/// A vector machine of L lanes, of which a run uses the first `width`; its counts are those of a
/// machine that has just these. Not thread-safe; counts of several machines merge by addition.
template <int L, Mode M>
requires LaneCount<L> &&(!is_slow(M)) class Machine {
 public:
  static constexpr int kLanes = L;
  /// Whether there are counts: bookkeeping of a kernel's own can be left out where there are none.
  static constexpr bool kCounted = M == Mode::kCounting;

  using Float = Vec<float, L>;
  using Int = Vec<std::int32_t, L>;
  using Uint = Vec<std::uint32_t, L>;
  using Lanes = Mask<L>;
  using Site = lanescope::Site<L, M>;

  /// Throws CheckError unless 1 <= width <= L.
  Machine(int width, std::size_t stage_count)
      : tally_(detail::checked_width(width, L).lanes, stage_count) {
    host::require_same_host();
  }

  LANESCOPE_INLINE int width() const { return tally_.width(); }
  /// All lanes of the width.
  LANESCOPE_INLINE Lanes all() const { return Lanes::first_n(width()); }
  /// The first n lanes; more than the width is all of them. Requires n >= 0.
  LANESCOPE_INLINE Lanes first_n(int n) const { return Lanes::first_n(n < width() ? n : width()); }

  /// A place that executes blocks of a stage. Throws CheckError unless stage < stage_count.
  LANESCOPE_INLINE Site site(std::size_t stage) { return Site(tally_, stage); }

  /// Marks that the program takes its next batch of work. Not an instruction.
  LANESCOPE_INLINE void begin_batch() {}

  /// Whether buffers should follow what has been written to them.
  static constexpr bool checks() { return false; }

  /// What a vector holds, for bookkeeping of the host. Not an instruction.
  template <class T>
  LANESCOPE_INLINE static const Vec<T, L>& look(const Vec<T, L>& v) {
    return v;
  }

  /// What has been counted by sites that have ended. Throws CheckError if two instructions have
  /// one mnemonic, or a block ran on lanes beyond the width.
  Counts counts() const { return tally_.counts(); }

 private:
  Tally tally_;
};

}  // namespace LANESCOPE_HOST
}  // namespace lanescope
