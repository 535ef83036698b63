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

/// Beyond its reach a probe may see megacubes: this many cubes along each axis, counted from the
/// probe, so that a megacube looks as the cube at the same place does that is as many times nearer.
inline constexpr int kMegaCube = 4;
/// A probe sees as many megacubes as cubes along each axis; those that its reach holds are skipped.
inline constexpr int kMegaSkipped = kReach / kMegaCube;
/// Places of megacubes along each axis that the corners of a brick see: of their cubes nearest to
/// the origin, from -kMegaCube * kReach on.
inline constexpr int kMegaPlaces = kBrickCorners - kMegaCube + 2 * kMegaCube * kReach;

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
  /// Behind the cubes may be megacubes, for each of the places along x modulo 4: bit b of the one
  /// word is the megacube at x = place + 4 b, bit b of the other the one at place + 4 (2 - b). A
  /// probe at x = place + 4 a sees 16 of them from bit a of the one on, and from bit 3 - a of the
  /// other.
  static constexpr int kMegaWords = kMegaCube * kMegaPlaces * kMegaPlaces * kRowWords;

  std::uint64_t element_count() const override { return probes.size(); }
  std::uint64_t hash() const override;

  /// The first word of the row of cubes with these y and z, 0 ... 47.
  static constexpr int row(int y, int z) { return (z * kBrickCubes + y) * kRowWords; }

  /// The first word of the row of megacubes with this x modulo 4, and these y and z of their cubes
  /// nearest to the origin, relative to that of the brick.
  static constexpr int mega_row(int place, int y, int z) {
    constexpr int kFirst = kMegaCube * kReach;
    return kWords + ((place * kMegaPlaces + z + kFirst) * kMegaPlaces + y + kFirst) * kRowWords;
  }

  bool has_megacubes() const { return rows.size() > kWords; }
  /// Whether the megacube is opaque whose cube nearest to the origin this is, relative to that of
  /// the brick. Requires one that a probe sees.
  bool mega_filled(Cube c) const {
    const int place = c.x & (kMegaCube - 1), step = (c.x - place) / kMegaCube;
    const int word = mega_row(place, c.y, c.z) + (step < 0 ? kBackward : kForward);
    return rows[static_cast<std::size_t>(word)] >> (step < 0 ? 2 - step : step) & 1;
  }
  /// Makes a megacube opaque. Requires one that a probe sees, and room for megacubes.
  void fill_mega(Cube c);

  /// Requires a cube of the brick.
  bool filled(Cube c) const {
    const int word = row(c.y, c.z) + (c.x < 16 ? kBackward : kForward);
    return rows[static_cast<std::size_t>(word)] >> (c.x < 16 ? 31 - c.x : c.x - 16) & 1;
  }
  /// Requires a cube of the brick.
  void fill(Cube c);
  /// Empties all cubes, and makes room for megacubes or not.
  void clear(bool with_megacubes = false) {
    rows.assign(with_megacubes ? kWords + kMegaWords : kWords, 0);
  }

  Cube origin;                      ///< The corner (0, 0, 0) in the world.
  std::uint64_t first_probe = 0;    ///< Number of the first probe among those of the scene.
  std::vector<std::uint32_t> rows;  ///< [kWords], or [kWords + kMegaWords]
  std::vector<Probe> probes;        ///< By z, y, x.
};

}  // namespace lanescope
