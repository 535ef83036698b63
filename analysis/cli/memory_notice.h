// SPDX-License-Identifier: MIT
// Says what an experiment takes before it takes it.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/experiment/experiment_groups.h"

namespace lanescope {

/// Tells how much memory the outputs of configurations take at a time, if it is much.
void tell_memory(const std::vector<Configuration>& configurations, const GroupLimits& limits = {});
/// The same of one output.
void tell_memory(std::uint64_t output_bytes);

}  // namespace lanescope
