// SPDX-License-Identifier: MIT
// What a machine counted: plain values that merge by addition, so that any order and any number of
// threads give the same totals.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "simulator/instruction.h"

namespace lanescope {

/// Counts of one instruction within one stage.
struct InstructionCounts {
  const InstructionInfo* info = nullptr;
  std::uint64_t issued = 0;           ///< Instructions issued.
  std::uint64_t active = 0;           ///< Lanes charged, summed over the instructions issued.
  std::uint64_t overhead_issued = 0;  ///< Those of `issued` that the kernel marked as overhead.
  std::uint64_t overhead_active = 0;  ///< Those of `active` that the kernel marked as overhead.

  InstructionCounts& operator+=(const InstructionCounts& other);
  bool operator==(const InstructionCounts&) const = default;
};

/// Counts of one stage of a kernel.
struct StageCounts {
  std::vector<InstructionCounts> instructions;  ///< One for each kind issued, by mnemonic.
  std::vector<std::uint64_t> lane_active;       ///< [W] instructions issued with lane i on.
  std::vector<std::uint64_t> histogram;         ///< [W + 1] instructions issued with k lanes on.

  /// Sum over the kinds of instruction; `info` is null.
  InstructionCounts total() const;
  StageCounts& operator+=(const StageCounts& other);
  bool operator==(const StageCounts&) const = default;
};

/// Counts of one run of a kernel on a machine of one width: a stage each, in the kernel's order.
/// Utilization of a stage is total().active / (total().issued * width).
struct Counts {
  int width = 0;
  std::vector<StageCounts> stages;

  Counts() = default;
  Counts(int width, std::size_t stage_count);
  /// Adds a count of one instruction kind to a stage.
  void add(std::size_t stage, const InstructionCounts& counts);
  /// Requires the same width and number of stages.
  Counts& operator+=(const Counts& other);
  bool operator==(const Counts&) const = default;
};

}  // namespace lanescope
