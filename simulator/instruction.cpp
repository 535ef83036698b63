// SPDX-License-Identifier: MIT
#include "simulator/instruction.h"

namespace lanescope {

std::string_view to_string(Charge charge) {
  switch (charge) {
    case Charge::kActiveLanes:
      return "active_lanes";
    case Charge::kAllLanes:
      return "all_lanes";
    case Charge::kOneLane:
      return "one_lane";
  }
  return {};
}

std::string_view to_string(InstructionClass instruction_class) {
  switch (instruction_class) {
    case InstructionClass::kArithmetic:
      return "arithmetic";
    case InstructionClass::kInteger:
      return "integer";
    case InstructionClass::kCompare:
      return "compare";
    case InstructionClass::kConvert:
      return "convert";
    case InstructionClass::kMove:
      return "move";
    case InstructionClass::kMask:
      return "mask";
    case InstructionClass::kMemory:
      return "memory";
    case InstructionClass::kReduce:
      return "reduce";
    case InstructionClass::kScan:
      return "scan";
    case InstructionClass::kSpecial:
      return "special";
  }
  return {};
}

}  // namespace lanescope
