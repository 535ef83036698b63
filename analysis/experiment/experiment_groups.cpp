// SPDX-License-Identifier: MIT
#include "analysis/experiment/experiment_groups.h"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace lanescope {
namespace {

/// Equal for configurations of the same source (same_source), and for no others.
std::string source_key(const Configuration& configuration) {
  constexpr char kEnd = '\0';  // Is in no name, value or path.
  const Workload& workload = workload_of(configuration);
  std::string key = std::string(workload.name) + kEnd + configuration.scene + kEnd;
  for (const Parameter& parameter : workload.parameters)
    key += value_text(configuration.arguments[parameter.name()]) + kEnd;
  return key;
}

std::uint64_t output_bytes(const Configuration& configuration) {
  const std::uint64_t bytes =
      find_kernel(configuration.kernel).output_bytes(configuration.arguments);
  return observes_apart(configuration) ? 2 * bytes : bytes;
}

struct Group {
  std::vector<std::size_t> members;
  std::uint64_t bytes = 0;

  bool has_room(std::uint64_t more, const GroupLimits& limits) const {
    return bytes + more <= limits.output_bytes && members.size() < limits.members;
  }
};

std::vector<Group> groups_of(const std::vector<Configuration>& configurations,
                             const GroupLimits& limits) {
  std::vector<Group> groups;
  std::unordered_map<std::string, std::size_t> latest;  // The last group of each source.
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const std::uint64_t bytes = output_bytes(configurations[i]);
    const auto [place, is_new] = latest.try_emplace(source_key(configurations[i]), groups.size());
    if (is_new || !groups[place->second].has_room(bytes, limits)) {
      place->second = groups.size();
      groups.emplace_back();
    }
    groups[place->second].members.push_back(i);
    groups[place->second].bytes += bytes;
  }
  return groups;
}

}  // namespace

std::vector<std::vector<std::size_t>> group_by_source(
    const std::vector<Configuration>& configurations, const GroupLimits& limits) {
  std::vector<std::vector<std::size_t>> indices;
  for (Group& group : groups_of(configurations, limits))
    indices.push_back(std::move(group.members));
  return indices;
}

std::uint64_t output_bytes(const std::vector<Configuration>& configurations,
                           const GroupLimits& limits) {
  std::uint64_t most = 0;
  for (const Group& group : groups_of(configurations, limits)) most = std::max(most, group.bytes);
  return most;
}

bool observes(const Configuration& configuration) {
  return configuration.observe_every != 0 && configuration.mode != Mode::kUncounted &&
         !find_kernel(configuration.kernel).stages.empty();
}

bool observes_apart(const Configuration& configuration) {
  return observes(configuration) && find_kernel(configuration.kernel).order == Order::kSequential;
}

int sequential_workers(std::size_t members, int threads) {
  return static_cast<int>(std::min(members, static_cast<std::size_t>(threads)));
}

int source_passes(const std::vector<Configuration>& group, int threads) {
  const auto sequential = static_cast<std::size_t>(std::count_if(
      group.begin(), group.end(),
      [](const Configuration& c) { return find_kernel(c.kernel).order == Order::kSequential; }));
  return sequential_workers(sequential, threads) + (sequential < group.size() ? 1 : 0);
}

}  // namespace lanescope
