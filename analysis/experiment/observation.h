// SPDX-License-Identifier: MIT
// What a tracing machine shows beside what a counting one counts: the lines of memory that
// instructions touch, the groups that their lanes fall into, and the lines of source that issue
// them.
#pragma once

#include <algorithm>
#include <array>
#include <source_location>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/report.h"
#include "simulator/observer.h"
#include "workloads/work.h"

namespace lanescope {

/// The distinct ones of a few numbers: those of one instruction after another.
class FewNumbers {
 public:
  void clear() {
    seen_ = {};
    numbers_.clear();
  }
  /// Whether the number is new.
  bool insert(std::uint64_t number) {
    const std::uint64_t hash = number * 0x9e3779b97f4a7c15u >> 56;
    std::uint64_t& seen = seen_[hash / 64];
    const std::uint64_t bit = std::uint64_t{1} << hash % 64;
    if ((seen & bit) != 0 && std::find(numbers_.begin(), numbers_.end(), number) != numbers_.end())
      return false;
    seen |= bit;
    numbers_.push_back(number);
    return true;
  }
  std::size_t size() const { return numbers_.size(); }

 private:
  std::array<std::uint64_t, 4> seen_{};  ///< A bit for the hash of each number.
  std::vector<std::uint64_t> numbers_;
};

/// Sums of observed executions, by stage and instruction and by line of source and block.
/// Observations merge by addition, so that pieces may be observed in any order on any thread.
class MemoryAndSource final : public Observer {
 public:
  MemoryAndSource() = default;
  MemoryAndSource(const MemoryAndSource&) = delete;
  MemoryAndSource& operator=(const MemoryAndSource&) = delete;

  void issued(const IssueEvent& event) override;
  MemoryAndSource& operator+=(const MemoryAndSource& other);

  /// The memory instructions of a stage, by mnemonic.
  std::vector<MemoryRecord> memory(std::size_t stage) const;
  /// The groups of the lanes of every instruction of a stage, by mnemonic.
  std::vector<LaneGroupRecord> lane_groups(std::size_t stage) const;
  /// By file, line, stage and block. `stages` names the kernel's stages.
  std::vector<SourceLineRecord> source_lines(std::span<const std::string_view> stages) const;

 private:
  /// An instruction at a line of source, in a block of a stage.
  struct Place {
    const InstructionInfo* info = nullptr;
    const char* file = nullptr;
    std::uint32_t line = 0;
    std::uint32_t stage = 0;
    std::source_location block{};

    bool operator==(const Place& other) const {
      return info == other.info && file == other.file && line == other.line &&
             stage == other.stage && block.line() == other.block.line() &&
             block.file_name() == other.block.file_name();
    }
  };
  /// Begins with a line of cache, as every instruction looks for one.
  struct alignas(64) Sum {
    Place place;
    std::uint64_t issued = 0;
    std::uint64_t active = 0;
    std::uint64_t overhead = 0;
    std::size_t memory = kNone;  ///< Place in memory_, or kNone.
    LaneGroups groups{};
  };
  static constexpr std::size_t kNone = ~std::size_t{0};

  /// The slot that a place has, or the free one that it would get.
  Sum& slot_of(const Place& place);
  /// The sum of a place, which may be new; then others move.
  Sum& sum_at(const Place& place);
  [[gnu::noinline]] Sum& new_sum(const Place& place);
  MemoryRecord& memory_of(Sum& sum);
  void add_touches(MemoryRecord& memory, const IssueEvent& event);
  /// Lanes that store to an element that an earlier one has stored to.
  std::uint64_t count_conflicts(std::span<const Touch> touches);
  /// Calls f(sum) for each place.
  template <class F>
  void for_each_sum(F&& f) const {
    for (const Sum& sum : slots_)
      if (sum.place.info != nullptr) f(sum);
  }

  std::vector<Sum> slots_ =
      std::vector<Sum>(256);  ///< By hash of place; a power of two, half of them free.
  std::size_t places_ = 0;
  std::vector<MemoryRecord> memory_;  ///< Of the places that access memory; without mnemonics.
  std::uint64_t latest_mask_ = 0;     ///< Instructions of a block have the same.
  LaneGroups latest_groups_;          ///< Of that mask.
  FewNumbers lines_touched_;
  FewNumbers elements_stored_;
};

/// Whether memory and source are observed in a piece of work. Depends on its place alone; the first
/// piece of a source is always observed unless `every` is 0.
bool is_observed(const Work& work, int every);

}  // namespace lanescope
