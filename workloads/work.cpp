// SPDX-License-Identifier: MIT
#include "workloads/work.h"

#include <algorithm>
#include <cctype>

namespace lanescope {

void merge_counters(std::span<const CounterInfo> infos, std::vector<std::uint64_t>& into,
                    const std::vector<std::uint64_t>& from) {
  into.resize(infos.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (infos[i].merge == Merge::kMaximum)
      into[i] = std::max(into[i], from[i]);
    else
      into[i] += from[i];
  }
}

bool Workload::is_file(std::string_view scene) const {
  if (file_ending.empty() || scene.size() < file_ending.size()) return false;
  return std::equal(
      file_ending.begin(), file_ending.end(),
      scene.end() - static_cast<std::ptrdiff_t>(file_ending.size()),
      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

const SceneInfo* Workload::find_scene(std::string_view name) const {
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const SceneInfo& s) { return s.name == name; });
  return found == scenes.end() ? nullptr : &*found;
}

}  // namespace lanescope
