// SPDX-License-Identifier: MIT
// The totals of a machine. A slow machine charges each instruction as it issues it. A fast one has
// a list for each site, of what one execution of its block issues, and hands over how often, and
// under which masks, the list was executed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/counts.h"
#include "simulator/instruction_list.h"

namespace lanescope {

/// An instruction as it is charged.
struct Issued {
  const InstructionInfo* info;
  bool overhead;
};

/// What one execution of a block issues: how often each instruction of the set, and which others.
struct IssueList {
  /// Counts of 16 bits, four to a word, by place in the instruction set: scalars in words rather
  /// than a list in memory, because a compiler folds those to constants in no time.
  static constexpr std::size_t kWords = (InstructionSet::kSize + 3) / 4;
  static constexpr std::uint64_t kMostTimes = 0xffff;
  /// Issues of instructions from outside the set. What exceeds one of these two limits is charged
  /// by itself, as it is issued.
  static constexpr int kForeign = 8;

  std::uint64_t baseline[kWords] = {};
  std::uint64_t overhead[kWords] = {};
  Issued foreign[kForeign] = {};
  int foreign_count = 0;
};

/// Totals by stage and instruction. Its size does not depend on what a program does: a list is
/// multiplied by its executions when a site hands them over, and kept no longer than the site.
class Tally {
 public:
  static constexpr std::size_t kNoPlace = ~std::size_t{0};

  Tally(int width, std::size_t stage_count);

  int width() const { return width_; }
  std::size_t stage_count() const { return stages_.size(); }

  /// Keeps the list of a site of the stage from now on; `place` is where its last one was, or
  /// kNoPlace. Returns where it is.
  std::size_t keep(std::size_t place, std::size_t stage, const IssueList& list);
  /// The site that had this place has ended.
  void forget(std::size_t place) { free_.push_back(place); }

  /// Adds executions of the list at a place: lane_executions[i] of them with lane i on,
  /// histogram[k] with k lanes on. Both may be longer than the machine is wide.
  void add(std::size_t place, std::span<const std::uint64_t> lane_executions,
           std::span<const std::uint64_t> histogram);

  /// Adds one instruction, issued in a block in which the lanes of `active` are on. Requires
  /// stage < stage_count.
  void charge(std::size_t stage, Issued issued, std::uint64_t active);

  /// What has been added so far. Throws CheckError if two instructions have one mnemonic, or lanes
  /// beyond the width were on.
  Counts counts() const;

 private:
  struct Stage {
    std::vector<InstructionCounts> instructions;  ///< In the order of their first issue.
    std::vector<std::uint64_t> lane_active;
    std::vector<std::uint64_t> histogram;
  };
  struct Kept {
    std::size_t stage = 0;
    IssueList list;
  };

  /// Adds `issued` executions in which `active` lanes were on altogether.
  void add(Stage& stage, Issued instruction, std::uint64_t issued, std::uint64_t active);

  int width_;
  std::vector<Stage> stages_;
  std::vector<Kept> kept_;
  std::vector<std::size_t> free_;  ///< Places in kept_ that no site has.
  bool beyond_width_ = false;      ///< Some lane beyond the width was on.
};

}  // namespace lanescope
