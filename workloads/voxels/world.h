// SPDX-License-Identifier: MIT
// A world of cubes: which are filled, and with what colour.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lanescope {

/// A cube of the lattice, or the corner of it that is nearest to the origin; y is up.
struct Cube {
  int x = 0, y = 0, z = 0;
  bool operator==(const Cube&) const = default;
};

/// Cubes 0 ... size - 1 along each axis; whatever is outside is empty. A cube has the number of a
/// colour, 0 if it is empty.
class World {
 public:
  /// Most cubes along an axis, and in all.
  static constexpr int kMostCubes = 1024;
  static constexpr std::size_t kMostVolume = std::size_t{1} << 27;

  using Colour = std::array<std::uint8_t, 3>;  ///< As displayed.

  /// An empty world. Requires sizes from 1 to kMostCubes, and at most kMostVolume cubes in all.
  explicit World(Cube size);

  Cube size() const { return size_; }
  bool contains(Cube c) const {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < size_.x && c.y < size_.y && c.z < size_.z;
  }
  bool filled(Cube c) const { return contains(c) && cubes_[index(c)] != 0; }
  /// 0 for an empty cube. Requires a cube of the world.
  std::uint8_t colour_number(Cube c) const { return cubes_[index(c)]; }
  const Colour& colour(Cube c) const { return palette[colour_number(c)]; }
  /// Requires a cube of the world. Number 0 empties it.
  void fill(Cube c, std::uint8_t colour_number) { cubes_[index(c)] = colour_number; }
  /// Filled cubes.
  std::uint64_t filled_count() const;

  std::array<Colour, 256> palette{};
  /// Probes are where a filled cube meets an empty one, at least this far from every side: 0 for
  /// all, 16 for those that see nothing of the outside.
  int margin = 0;

 private:
  std::size_t index(Cube c) const {
    return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(size_.y) +
            static_cast<std::size_t>(c.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(c.x);
  }

  Cube size_;
  std::vector<std::uint8_t> cubes_;  ///< [z][y][x]
};

}  // namespace lanescope
