// SPDX-License-Identifier: MIT
#include "analysis/experiment/experiment_groups.h"

#include <algorithm>

namespace lanescope {
namespace {

std::int64_t frame_bytes(const Configuration& c) {
  return c.sample_grid().sample_count() * static_cast<std::int64_t>(sizeof(std::uint64_t));
}

struct Group {
  std::vector<std::size_t> members;
  std::int64_t bytes = 0;
};

}  // namespace

std::vector<std::vector<std::size_t>> group_by_tessellation(
    const std::vector<Configuration>& configurations, const GroupLimits& limits) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const std::int64_t bytes = frame_bytes(configurations[i]);
    auto place = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      return same_tessellation(configurations[g.members.front()], configurations[i]) &&
             g.bytes + bytes <= limits.frame_bytes && g.members.size() < limits.members;
    });
    if (place == groups.end()) place = groups.insert(groups.end(), Group{});
    place->members.push_back(i);
    place->bytes += bytes;
  }
  std::vector<std::vector<std::size_t>> indices;
  for (Group& g : groups) indices.push_back(std::move(g.members));
  return indices;
}

}  // namespace lanescope
