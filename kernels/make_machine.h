// SPDX-License-Identifier: MIT
// The machine that a vector program of any kind runs on.
#pragma once

#include "kernels/kernel.h"
#include "simulator/machine.h"
#include "simulator/slow_machine.h"

namespace lanescope {

/// The machine that a launch asks for. Requires one of Vm's modes.
template <class Vm>
Vm make_machine(const Launch& launch, std::size_t stage_count) {
  if constexpr (requires { Vm(launch.width, stage_count, launch.mode, launch.observer); })
    return Vm(launch.width, stage_count, launch.mode, launch.observer);
  else
    return Vm(launch.width, stage_count);
}

}  // namespace lanescope
