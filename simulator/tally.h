// SPDX-License-Identifier: MIT
// The totals of a machine. A slow machine charges each instruction as it issues it. A fast one has
// a log for each site: the list of what one execution of its block issues, and the masks under
// which the list was executed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "simulator/counts.h"
#include "simulator/instruction_list.h"
#include "simulator/mask_sums.h"

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

/// What a site has executed since it began its list.
struct SiteLog {
  /// The latest masks, as LoggedMask; how many, the site knows.
  alignas(64) std::byte masks[MaskSums::kMostBytes];
  MaskSums sums;  ///< Of those before.
  IssueList list;
  std::size_t stage;

  template <class Word>
  Word* begin() {
    return reinterpret_cast<Word*>(masks);
  }
  template <class Word>
  Word* end() {
    return begin<Word>() + MaskSums::kMostBytes / sizeof(Word);
  }
  /// Takes the masks before `next` into the sums.
  template <class Word>
  void sum_up(const Word* next) {
    sums.add<Word>(begin<Word>(), next);
  }
};

/// Totals by stage and instruction. Its size does not depend on what a program does: a list is
/// multiplied by its executions when its site ends or begins another one.
class Tally {
 public:
  Tally(int width, std::size_t stage_count);

  int width() const { return width_; }
  std::size_t stage_count() const { return stages_.size(); }

  /// A log for a site of the stage. Requires stage < stage_count.
  SiteLog& open(std::size_t stage);
  /// Adds what was logged and summed up, and empties the log.
  void take(SiteLog& log);
  /// The site has ended, and its log has been taken.
  void close(SiteLog& log) { free_.push_back(&log); }

  /// Adds one instruction, issued in a block in which the lanes of `active` are on. Requires
  /// stage < stage_count.
  void charge(std::size_t stage, Issued issued, std::uint64_t active);

  /// What has been added so far. Throws CheckError if two instructions have one mnemonic, or lanes
  /// beyond the width were on.
  Counts counts() const;

 private:
  struct Stage {
    std::vector<InstructionCounts> instructions;  ///< In the order of their first issue.
    std::array<std::uint32_t, 64> recent{};       ///< Places of some, by hash.
    std::vector<std::uint64_t> lane_active;
    std::vector<std::uint64_t> histogram;
  };

  static InstructionCounts& counts_of(Stage& stage, const InstructionInfo* info);
  /// Adds `issued` executions in which `active` lanes were on altogether.
  void add(Stage& stage, Issued instruction, std::uint64_t issued, std::uint64_t active);

  int width_;
  std::vector<Stage> stages_;
  std::vector<std::unique_ptr<SiteLog>> logs_;
  std::vector<SiteLog*> free_;  ///< Those of logs_ that no site has.
  bool beyond_width_ = false;   ///< Some lane beyond the width was on.
};

}  // namespace lanescope
