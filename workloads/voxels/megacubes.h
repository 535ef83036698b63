// SPDX-License-Identifier: MIT
// Which blocks of 4 x 4 x 4 cubes of a world are opaque from afar.
#pragma once

#include <cstdint>
#include <vector>

#include "workloads/voxels/brick.h"
#include "workloads/voxels/world.h"

namespace lanescope {

/// All megacubes of a world, at each cube: probes count theirs from where they are.
class Megacubes {
 public:
  /// A megacube is opaque if at least this share of its cubes is filled (and one of them).
  Megacubes(const World& world, float least_share);

  /// Whether the megacube is opaque whose cube nearest to the origin this is; outside none is.
  bool opaque(Cube c) const;

 private:
  std::size_t index(Cube c) const;

  Cube size_;                         ///< Of the world, and the places before it.
  std::vector<std::uint8_t> filled_;  ///< [z][y][x] Cubes that are, from (-3, -3, -3) on.
  int least_;
};

}  // namespace lanescope
