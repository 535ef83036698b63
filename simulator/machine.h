// SPDX-License-Identifier: MIT
// The machine. A program names a stage at a site, opens a block there under a mask, and issues
// instructions in the block:
//
//   Machine<16, Mode::kCounting> vm(stage_count);
//   auto test = vm.site(kTest);             // outside the loop
//   while (...) {
//     auto on = test.on(active);            // until the end of the scope
//     const auto e = sub(on, mul(on, ax, by), mul(on, ay, bx));
//   }
//
// Counting happens when a block ends. A block keeps a list of what it has issued, and a signature
// of the list; in straight-line code the compiler folds both to constants, and all that runs is:
// compare the signature with the site's, increment the histogram of active lanes, add the mask to
// the lanes' counts. When the signature differs (the first execution, another path through a block
// with branches) the list itself is handed to the Tally, so counts are exact always.
//
// A site is a local variable, and its address must not escape: counters that an output store may
// alias cost a factor of two. Whatever leaves it is copied first.
#pragma once

#include <cstdint>
#include <source_location>
#include <type_traits>

#include "simulator/base/error.h"
#include "simulator/lane_counter.h"
#include "simulator/mode.h"
#include "simulator/observer.h"
#include "simulator/tally.h"
#include "simulator/vector.h"

namespace lanescope {

/// A vector of a checked machine: which lanes hold a value; the others are poison.
template <class T, int W>
struct CheckedVec {
  using Element = T;
  Vec<T, W> vec;
  Mask<W> defined = Mask<W>::none();
};

namespace detail {

/// Whom a site of a tracing machine tells; nothing on other machines.
template <Mode M>
struct Watched {
  LANESCOPE_INLINE explicit Watched(Observer*) {}
};
template <>
struct Watched<Mode::kTracing> {
  explicit Watched(Observer* observer) : observer(observer) {}
  Observer* observer;
};

/// A 64-bit hash of a name, for signatures.
constexpr std::uint64_t hash_name(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash | 1;
}

// The slow paths are noexcept (out of memory ends the program): an exception's way out of the hot
// loop would keep the counters in memory.

/// What a site has counted since it last handed its counts over: executions of one list.
template <int W>
struct SiteCounts {
  LaneCounter<W> lanes;
  std::uint64_t histogram[W + 1];
};

template <int W>
[[gnu::noinline, gnu::cold]] void hand_over(Tally& tally, std::size_t stage, std::size_t list,
                                            const SiteCounts<W>& counts) noexcept {
  const auto lanes = counts.lanes.counts();
  tally.add(stage, list, {lanes.data(), static_cast<std::size_t>(W)}, counts.histogram);
}

[[gnu::noinline, gnu::cold]] inline std::size_t intern(Tally& tally, std::size_t stage,
                                                       std::uint64_t signature,
                                                       const IssueList& list) noexcept {
  return tally.intern(stage, signature, list);
}

/// A block has issued more than its list can hold.
[[noreturn, gnu::cold]] void fail_block_length(const InstructionInfo& info);

}  // namespace detail

template <int W, Mode M>
class Block;

/// A place in a program that executes blocks of one stage. Local, outside the loop.
template <int W, Mode M>
class Site : private detail::Watched<M> {
 public:
  LANESCOPE_INLINE Site(Tally& tally, std::size_t stage, Observer* observer)
      : detail::Watched<M>(observer), tally_(tally), stage_(stage) {}
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;
  LANESCOPE_INLINE ~Site() {
    if (signature_ != 0) hand_over();
  }

  /// Opens a block of instructions that run under `active`.
  LANESCOPE_INLINE Block<W, M> on(Mask<W> active) { return Block<W, M>(*this, active); }

 private:
  friend class Block<W, M>;

  LANESCOPE_INLINE void hand_over() {
    detail::SiteCounts<W> copy{lanes_.copy(), {}};
    for (int k = 0; k <= W; ++k) copy.histogram[k] = histogram_[k];
    detail::hand_over<W>(tally_, stage_, list_, copy);
  }

  LANESCOPE_INLINE void restart() {
    lanes_.reset();
    budget_ = LaneCounter<W>::kCapacity;
    for (int k = 0; k <= W; ++k) histogram_[k] = 0;
  }

  /// Makes room in the lanes' counters for the execution that is about to be counted.
  LANESCOPE_INLINE void renew() {
    hand_over();
    restart();
    --budget_;
  }

  LANESCOPE_INLINE void executed(Mask<W> active) {
    ++histogram_[active.count()];
    lanes_.add(active);
  }

  Tally& tally_;
  std::size_t stage_;
  std::uint64_t signature_ = 0;  ///< Of the list that is being counted; 0 is none.
  std::size_t list_ = 0;
  // Executions of the list by lane and by number of active lanes. Copied element by element: a
  // memcpy would take the site's address, and nothing of it could stay in a register.
  LaneCounter<W> lanes_;
  std::uint64_t histogram_[W + 1] = {};
  std::int32_t budget_ = 0;  ///< Executions until the lanes' counters are full.
};

/// Code under one mask. Instructions issued in it are charged when it ends.
template <int W, Mode M>
class Block {
 public:
  static constexpr int kWidth = W;
  static constexpr Mode kMode = M;

  LANESCOPE_INLINE Block(Site<W, M>& site, Mask<W> active) : site_(site), active_(active) {}
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  LANESCOPE_INLINE ~Block() { end(); }

  LANESCOPE_INLINE Mask<W> active() const { return active_; }

  /// The same block for instructions that the kernel's baseline does not have to execute.
  struct Overhead {
    static constexpr int kWidth = W;
    static constexpr Mode kMode = M;
    Block& block;
    LANESCOPE_INLINE Mask<W> active() const { return block.active_; }
    void tell(const InstructionInfo& info, const std::source_location& at,
              std::span<const Touch> touches) const {
      block.tell_observer(info, true, at, touches);
    }
    template <class Op>
    LANESCOPE_INLINE void charge() {
      block.template append<Op, true>();
    }
  };
  LANESCOPE_INLINE Overhead overhead() { return {*this}; }

  template <class Op>
  LANESCOPE_INLINE void charge() {
    append<Op, false>();
  }

  /// Tells the observer of a tracing machine what is issued in the block.
  void tell(const InstructionInfo& info, const std::source_location& at,
            std::span<const Touch> touches) const {
    tell_observer(info, false, at, touches);
  }

 private:
  void tell_observer(const InstructionInfo& info, bool overhead, const std::source_location& at,
                     std::span<const Touch> touches) const {
    site_.observer->issued({info, site_.stage_, W, active_.bits(), overhead, at, touches});
  }

  template <class Op, bool kOverhead>
  LANESCOPE_INLINE void append() {
    if constexpr (M != Mode::kUncounted) {
      constexpr std::size_t kIndex = kInstructionIndex<Op>;
      if constexpr (kIndex < InstructionSet::kSize) {
        constexpr int kShift = 16 * (kIndex % 4);
        std::uint64_t& word = (kOverhead ? overhead_ : baseline_)[kIndex / 4];
        if ((word >> kShift & 0xffff) == 0xffff) detail::fail_block_length(Op::kInfo);
        word += std::uint64_t{1} << kShift;
      } else {
        if (foreign_count_ == IssueList::kForeign) detail::fail_block_length(Op::kInfo);
        foreign_[foreign_count_] = {&Op::kInfo, kOverhead};
        ++foreign_count_;
      }
      constexpr std::uint64_t kHash = detail::hash_name(Op::kInfo.mnemonic) + 2 * kOverhead;
      signature_ = (signature_ + kHash) * 0x9e3779b97f4a7c15u;
      signature_ ^= signature_ >> 29;
    }
  }

  LANESCOPE_INLINE void end() {
    if constexpr (M != Mode::kUncounted) {
      if (signature_ == 0) return;
      if (site_.signature_ != signature_) [[unlikely]]
        switch_list();
      if (--site_.budget_ < 0) [[unlikely]]
        site_.renew();
      site_.executed(active_);
    }
  }

  LANESCOPE_INLINE void switch_list() {
    if (site_.signature_ != 0) site_.hand_over();
    site_.restart();
    IssueList copy;
    host::unroll<IssueList::kWords>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      copy.baseline[i] = baseline_[i];
      copy.overhead[i] = overhead_[i];
    });
    copy.foreign_count = foreign_count_;
    host::unroll<IssueList::kForeign>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      if (i < foreign_count_) copy.foreign[i] = foreign_[i];
    });
    site_.list_ = detail::intern(site_.tally_, site_.stage_, signature_, copy);
    site_.signature_ = signature_;
  }

  Site<W, M>& site_;
  Mask<W> active_;
  std::uint64_t signature_ = 0;
  // The list (see IssueList), in members of its own: an aggregate that is copied stays in memory.
  std::uint64_t baseline_[IssueList::kWords] = {};
  std::uint64_t overhead_[IssueList::kWords] = {};
  ForeignIssue foreign_[IssueList::kForeign];
  int foreign_count_ = 0;
};

/// A vector machine of width W. Not thread-safe; counts of several machines merge by addition.
template <int W, Mode M>
requires Width<W>
class Machine {
 public:
  static constexpr int kWidth = W;
  static constexpr Mode kMode = M;
  static constexpr bool kCheckedMode = M == Mode::kChecked;

  template <class T>
  using VecOf = std::conditional_t<kCheckedMode, CheckedVec<T, W>, Vec<T, W>>;
  using Float = VecOf<float>;
  using Int = VecOf<std::int32_t>;
  using Uint = VecOf<std::uint32_t>;
  using Lanes = Mask<W>;

  /// A tracing machine needs an observer, which must outlive it; others have none.
  explicit Machine(std::size_t stage_count, Observer* observer = nullptr)
      : tally_(W, stage_count), observer_(observer) {
    LANESCOPE_CHECK((observer != nullptr) == (M == Mode::kTracing),
                    "a machine has an observer if and only if it is tracing");
  }

  /// A place that executes blocks of a stage. Requires stage < stage_count.
  LANESCOPE_INLINE Site<W, M> site(std::size_t stage) { return Site<W, M>(tally_, stage, observer_); }

  /// Marks that the program takes its next batch of W elements of work. Not an instruction.
  LANESCOPE_INLINE void begin_batch() {
    if constexpr (M == Mode::kTracing) observer_->batch_begins();
  }

  /// What has been counted by sites that have ended.
  Counts counts() const { return tally_.counts(); }

 private:
  Tally tally_;
  Observer* observer_;
};

}  // namespace lanescope
