// SPDX-License-Identifier: MIT
// Which configurations run together: those that one tessellation feeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

struct GroupLimits {
  /// Frames of a group together, unless a single one is larger.
  std::int64_t frame_bytes = std::int64_t{768} << 20;
  /// Configurations in a group. Requires at least 1.
  std::size_t members = std::numeric_limits<std::size_t>::max();
};

/// Indices of the configurations in groups of the same tessellation, within the limits. Groups are
/// in the order of their first members, and members in the order of the configurations.
std::vector<std::vector<std::size_t>> group_by_tessellation(
    const std::vector<Configuration>& configurations, const GroupLimits& limits);

}  // namespace lanescope
