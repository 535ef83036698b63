// SPDX-License-Identifier: MIT
// Which configurations run together: those that one source feeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

struct GroupLimits {
  /// Outputs of a group together, unless a single one is larger.
  std::uint64_t output_bytes = std::uint64_t{768} << 20;
  /// Configurations in a group. Requires at least 1.
  std::size_t members = std::numeric_limits<std::size_t>::max();
};

/// Indices of the configurations in groups of the same source, within the limits. Groups are in the
/// order of their first members, and members in the order of the configurations. Throws InputError
/// for a kernel that there is not.
std::vector<std::vector<std::size_t>> group_by_source(
    const std::vector<Configuration>& configurations, const GroupLimits& limits);

/// The memory that outputs take at a time when these groups run one after another.
std::uint64_t output_bytes(const std::vector<Configuration>& configurations,
                           const GroupLimits& limits);

/// Whether memory and source lines are observed in some pieces of a configuration's work.
bool observes(const Configuration& configuration);

/// Whether what is observed needs an output of its own, as each piece is then taken twice.
bool observes_apart(const Configuration& configuration);

/// Workers that share the members of Order::kSequential of a group: each takes all pieces.
int sequential_workers(std::size_t members, int threads);

/// How often the pieces of a group are made: once for its members of Order::kAny together, and once
/// for each of the sequential workers.
int source_passes(const std::vector<Configuration>& group, int threads);

}  // namespace lanescope
