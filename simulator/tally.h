// SPDX-License-Identifier: MIT
// The totals of a machine, behind the hot path: lists of instructions and how often, and under
// which masks, each list was executed.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "simulator/counts.h"
#include "simulator/instruction_list.h"

namespace lanescope {

/// An instruction that is not in the set, issued once.
struct ForeignIssue {
  const InstructionInfo* info;
  bool overhead;
  bool operator==(const ForeignIssue&) const = default;
};

/// What one execution of a block issued: how often each instruction of the set, and which others.
struct IssueList {
  /// Counts of 16 bits, four to a word, by place in the instruction set: scalars in words rather
  /// than a list in memory, because a compiler folds those to constants in no time.
  static constexpr std::size_t kWords = (InstructionSet::kSize + 3) / 4;
  static constexpr int kForeign = 8;

  std::uint64_t baseline[kWords] = {};
  std::uint64_t overhead[kWords] = {};
  ForeignIssue foreign[kForeign] = {};
  int foreign_count = 0;

  bool operator==(const IssueList&) const = default;
};

/// Totals by stage and list. All instructions of a list ran under one mask, so executions are
/// counted by mask and multiplied at the end.
class Tally {
 public:
  Tally(int width, std::size_t stage_count) : width_(width), stages_(stage_count) {}

  /// The handle of a list within a stage; equal lists have one handle. `signature` is a hash of it.
  std::size_t intern(std::size_t stage, std::uint64_t signature, const IssueList& issued);

  /// Adds executions of a list: lane_executions[i] of them with lane i on, histogram[k] with k
  /// lanes on.
  void add(std::size_t stage, std::size_t list, std::span<const std::uint16_t> lane_executions,
           std::span<const std::uint64_t> histogram);

  Counts counts() const;

 private:
  struct List {
    IssueList issued;
    std::vector<std::uint64_t> lane_executions;
    std::vector<std::uint64_t> histogram;
  };
  struct Stage {
    std::vector<List> lists;
    std::multimap<std::uint64_t, std::size_t> by_signature;
  };

  void add_list(Counts& counts, std::size_t stage, const List& list) const;

  int width_;
  std::vector<Stage> stages_;
};

}  // namespace lanescope
