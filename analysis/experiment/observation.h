// SPDX-License-Identifier: MIT
// What a tracing machine shows beside what a counting one counts: the lines of memory that
// instructions touch, and the lines of source that issue them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/report/report.h"
#include "simulator/observer.h"
#include "workloads/work.h"

namespace lanescope {

/// A set of numbers that is cleared in no time: for one instruction after another.
class SmallSet {
 public:
  void clear() {
    ++generation_;
    size_ = 0;
  }
  /// Whether the number is new.
  bool insert(std::uint64_t number) {
    if (2 * size_ >= slots_.size()) grow();
    for (std::size_t i = number * 0x9e3779b97f4a7c15u >> shift_;; i = (i + 1) % slots_.size()) {
      Slot& slot = slots_[i];
      if (slot.generation != generation_) {
        slot = {number, generation_};
        ++size_;
        return true;
      }
      if (slot.number == number) return false;
    }
  }

 private:
  struct Slot {
    std::uint64_t number = 0;
    std::uint64_t generation = 0;
  };

  void grow() {
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    --shift_;
    size_ = 0;
    for (const Slot& slot : old)
      if (slot.generation == generation_) insert(slot.number);
  }

  int shift_ = 64 - 9;  ///< Leaves as many bits as there are in the place of a slot.
  std::vector<Slot> slots_ = std::vector<Slot>(std::size_t{1} << 9);
  std::uint64_t generation_ = 1;
  std::size_t size_ = 0;  ///< Numbers of this generation.
};

/// Sums of observed executions, by stage and instruction and by line of source. Observations merge
/// by addition, so that pieces may be observed in any order on any thread.
class MemoryAndSource final : public Observer {
 public:
  MemoryAndSource() = default;
  MemoryAndSource(const MemoryAndSource&) = delete;
  MemoryAndSource& operator=(const MemoryAndSource&) = delete;

  void issued(const IssueEvent& event) override;
  MemoryAndSource& operator+=(const MemoryAndSource& other);

  /// The memory instructions of a stage, by mnemonic.
  std::vector<MemoryRecord> memory(std::size_t stage) const;
  /// By file, line and stage. `stages` names the kernel's stages.
  std::vector<SourceLineRecord> source_lines(std::span<const std::string_view> stages) const;

 private:
  /// An instruction at a line of source, in a stage.
  struct Place {
    const char* file = nullptr;
    std::uint32_t line = 0;
    std::size_t stage = 0;
    const InstructionInfo* info = nullptr;
    bool operator==(const Place&) const = default;
  };
  struct PlaceHash {
    std::size_t operator()(const Place& place) const;
  };
  struct Sum {
    std::uint64_t issued = 0;
    std::uint64_t active = 0;
    std::uint64_t overhead = 0;
    MemoryRecord memory;  ///< Of a memory instruction; without mnemonic.
  };
  /// The sums of recent places by their hash: a loop issues the same instructions again and again.
  static constexpr std::size_t kRecent = 1024;
  struct Recent {
    Place place;
    Sum* sum = nullptr;
  };

  Sum& sum_at(const Place& place);
  void add_touches(MemoryRecord& memory, const IssueEvent& event);
  /// Lanes that store to an element that an earlier one has stored to.
  std::uint64_t count_conflicts(std::span<const Touch> touches);

  std::unordered_map<Place, Sum, PlaceHash> sums_;
  std::array<Recent, kRecent> recent_{};
  SmallSet lines_touched_;
  SmallSet elements_stored_;
};

/// Whether memory and source are observed in a piece of work. Depends on its place alone; the first
/// piece of a source is always observed unless `every` is 0.
bool is_observed(const Work& work, int every);

}  // namespace lanescope
