// SPDX-License-Identifier: MIT
// How the lanes that are on fall into groups: a machine whose vectors have N lanes takes a wider
// vector N neighbours at a time.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace lanescope {

/// The sizes N of groups, by place: 2 to the power of the place.
inline constexpr std::array<int, 7> kGroupLanes{1, 2, 4, 8, 16, 32, 64};

/// The place of a size among them; without one, of the largest, which holds all lanes. Requires
/// that it is one of them.
constexpr std::size_t place_of_groups(std::optional<int> lanes) {
  return lanes ? static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(*lanes)))
               : kGroupLanes.size() - 1;
}

/// A count for each size of groups.
using GroupCounts = std::array<std::uint64_t, kGroupLanes.size()>;

struct LaneGroups {
  GroupCounts active{};  ///< Groups with a lane on.
  GroupCounts dense{};   ///< Groups that would hold the lanes that are on, one beside the other.

  LaneGroups& operator+=(const LaneGroups& other) {
    for (std::size_t place = 0; place < kGroupLanes.size(); ++place) {
      active[place] += other.active[place];
      dense[place] += other.dense[place];
    }
    return *this;
  }
  bool operator==(const LaneGroups&) const = default;
};

/// Those of one execution; bit i of the mask is lane i.
constexpr LaneGroups lane_groups_of(std::uint64_t mask) {
  constexpr GroupCounts kFirstLanes{~std::uint64_t{0},
                                    0x5555555555555555u,
                                    0x1111111111111111u,
                                    0x0101010101010101u,
                                    0x0001000100010001u,
                                    0x0000000100000001u,
                                    1};
  LaneGroups groups;
  const auto lanes = static_cast<std::uint64_t>(std::popcount(mask));
  for (std::size_t place = 0; place < kGroupLanes.size(); ++place) {
    const auto size = static_cast<std::uint64_t>(kGroupLanes[place]);
    // What is on in a group is gathered in the bit of its first lane.
    if (place > 0) mask = (mask | mask >> size / 2) & kFirstLanes[place];
    groups.active[place] = static_cast<std::uint64_t>(std::popcount(mask));
    groups.dense[place] = (lanes + size - 1) / size;
  }
  return groups;
}

}  // namespace lanescope
