// SPDX-License-Identifier: MIT
// A piece of work: probes of a brick of 16 x 16 x 16 corners, and whether each cube is filled of
// those that they see.
#pragma once

#include <cstdint>
#include <vector>

#include "workloads/voxels/world.h"
#include "workloads/work.h"

namespace lanescope {

/// A probe sees this many cubes along each axis.
inline constexpr int kReach = 16;
/// A brick has this many corners along each axis.
inline constexpr int kBrickCorners = 16;
inline constexpr int kMostProbes = kBrickCorners * kBrickCorners * kBrickCorners;
/// Cubes along each axis that the corners of a brick see.
inline constexpr int kBrickCubes = kBrickCorners + 2 * kReach;

/// A corner of the lattice to render from, with its place in the brick: 0 ... 15 along each axis.
struct Probe {
  std::uint8_t x = 0, y = 0, z = 0;
  bool operator==(const Probe&) const = default;
};

/// Rows of cubes as bits, and the probes. Cube x of the brick, 0 ... 47, is cube
/// origin.x - kReach + x of the world.
struct Brick final : Work {
  /// Words of a row, one for either way that a probe looks along it: bit b of the one is cube
  /// 16 + b, bit b of the other cube 31 - b. A probe at x sees the 16 cubes from bit x of the one
  /// on, and from bit 16 - x of the other.
  enum RowWord { kForward, kBackward, kRowWords };
  static constexpr int kWords = kBrickCubes * kBrickCubes * kRowWords;

  std::uint64_t element_count() const override { return probes.size(); }
  std::uint64_t hash() const override;

  /// The first word of the row of cubes with these y and z, 0 ... 47.
  static constexpr int row(int y, int z) { return (z * kBrickCubes + y) * kRowWords; }

  /// Requires a cube of the brick.
  bool filled(Cell c) const {
    const int word = row(c.y, c.z) + (c.x < 16 ? kBackward : kForward);
    return rows[static_cast<std::size_t>(word)] >> (c.x < 16 ? 31 - c.x : c.x - 16) & 1;
  }
  /// Requires a cube of the brick.
  void fill(Cell c);
  /// Empties all cubes.
  void clear() { rows.assign(kWords, 0); }

  Cell origin;                      ///< The corner (0, 0, 0) in the world.
  std::uint64_t first_probe = 0;    ///< Number of the first probe among those of the scene.
  std::vector<std::uint32_t> rows;  ///< [kWords]
  std::vector<Probe> probes;        ///< By z, y, x.
};

}  // namespace lanescope
