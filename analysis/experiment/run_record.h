// SPDX-License-Identifier: MIT
// From what a kernel, its source and its output counted to what a report says of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/experiment/observation.h"
#include "analysis/report/report.h"

namespace lanescope {

/// Values in the order of `infos`, with what they are. Requires as many of both.
std::vector<CounterRecord> counter_records(std::span<const CounterInfo> infos,
                                           const std::vector<std::uint64_t>& values);

/// A run without its source and its output.
RunRecord run_record(const Configuration& configuration, const Kernel& kernel,
                     const KernelResult& result, const MemoryAndSource& seen);

}  // namespace lanescope
