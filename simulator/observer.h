// SPDX-License-Identifier: MIT
// What a tracing machine tells of every instruction that it issues.
#pragma once

#include <bit>
#include <cstdint>
#include <source_location>
#include <span>

#include "simulator/instruction.h"
#include "simulator/memory.h"

namespace lanescope {

/// An element that a memory instruction touches.
struct Touch {
  int lane;
  std::uint64_t byte;   ///< Offset of the element from the start of its memory.
  std::uint32_t bytes;  ///< Size of the element.
  Access access;

  bool stores() const { return access != Access::kLoad; }
};

/// An instruction as it is issued.
struct IssueEvent {
  const InstructionInfo& info;
  std::size_t stage;
  int width;             ///< Of the machine.
  std::uint64_t active;  ///< Bit i: lane i is on in the block.
  bool overhead;         ///< The kernel marks it as work that its baseline does not have.
  std::source_location at;
  /// Of a memory instruction, in the order of lanes; all are in one memory.
  std::span<const Touch> touches;
  /// Where its block was opened: the line of the kernel that a shared helper was called for.
  std::source_location block{};

  /// The lanes that the instruction is charged.
  std::uint64_t charged() const {
    return charged_lanes(info.charge, 1, static_cast<std::uint64_t>(std::popcount(active)), width);
  }
};

/// Watches a slow machine. Called on the thread of the machine.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void issued(const IssueEvent& event) = 0;
  /// The program takes its next batch of work.
  virtual void batch_begins() {}
};

}  // namespace lanescope
