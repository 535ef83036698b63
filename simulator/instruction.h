// SPDX-License-Identifier: MIT
// What describes an instruction: name, meaning, class, what it charges. See docs/conventions.md.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace lanescope {

/// The lanes an issued instruction is charged as doing work.
enum class Charge {
  kActiveLanes,  ///< The lanes that are on in its block.
  kAllLanes,     ///< All W lanes, whatever the mask.
  kOneLane,      ///< One lane.
};

inline constexpr std::array kCharges{Charge::kActiveLanes, Charge::kAllLanes, Charge::kOneLane};

enum class InstructionClass {
  kArithmetic,
  kInteger,
  kCompare,
  kConvert,
  kMove,
  kMask,
  kMemory,
  kReduce,
  kScan,
  kSpecial
};

inline constexpr std::array kInstructionClasses{
    InstructionClass::kArithmetic, InstructionClass::kInteger, InstructionClass::kCompare,
    InstructionClass::kConvert,    InstructionClass::kMove,    InstructionClass::kMask,
    InstructionClass::kMemory,     InstructionClass::kReduce,  InstructionClass::kScan,
    InstructionClass::kSpecial};

/// The descriptor that every instruction struct carries as `kInfo`; its address identifies the
/// instruction, its mnemonic names it in reports and must be unique.
struct InstructionInfo {
  std::string_view mnemonic;
  std::string_view meaning;
  InstructionClass instruction_class;
  Charge charge = Charge::kActiveLanes;
  /// What it gives where a reader might expect something else: limits, zeros, not-a-number, no
  /// active lane. The same on every host.
  std::string_view edges = {};
};

/// Lanes charged for `executions` of an instruction in which `active` lanes were on altogether.
constexpr std::uint64_t charged_lanes(Charge charge, std::uint64_t executions, std::uint64_t active,
                                      int width) {
  switch (charge) {
    case Charge::kActiveLanes:
      return active;
    case Charge::kAllLanes:
      return executions * static_cast<std::uint64_t>(width);
    case Charge::kOneLane:
      return executions;
  }
  return 0;
}

std::string_view to_string(Charge charge);
std::string_view to_string(InstructionClass instruction_class);

}  // namespace lanescope
