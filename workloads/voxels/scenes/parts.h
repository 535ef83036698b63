// SPDX-License-Identifier: MIT
// What worlds are built of: materials, random numbers of places, boxes and trees.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "simulator/base/random.h"
#include "workloads/geometry/noise.h"
#include "workloads/voxels/world.h"

namespace lanescope {

/// Numbers of a palette whose colours differ slightly; each cube of the material has one of them.
struct CubeMaterial {
  std::uint8_t first = 0;
  std::uint8_t shades = 0;
};

/// Noise with features about so many cubes apart.
class NoiseField {
 public:
  NoiseField(float width_cubes, Vec3 shift) : scale_(1.0f / width_cubes), shift_(shift) {}

  float at(Vec3 p) const { return noise(p * scale_ + shift_); }
  /// With details, each octave of half the size and height of the one before.
  float at(Vec3 p, int octaves) const { return fractal_noise(p * scale_ + shift_, octaves); }

 private:
  float scale_;
  Vec3 shift_;
};

/// Fills cubes of a new world. Cubes outside are left out, so that things may reach over its sides.
/// Random numbers are those of a seed, a place and a use, whatever was asked for before.
class WorldBuilder {
 public:
  WorldBuilder(Cube size, std::uint64_t seed) : world_(size), seed_(mix64(seed)) {}

  World take() { return std::move(world_); }
  Cube size() const { return world_.size(); }

  /// A material about a colour; `contrast` is how much lighter the lightest shade is than it.
  CubeMaterial material(World::Colour colour, float contrast = 0.06f) {
    constexpr int kShades = 5;
    const CubeMaterial made{next_, kShades};
    for (int shade = 0; shade < kShades; ++shade) {
      World::Colour& entry = world_.palette[next_++];
      for (std::size_t channel = 0; channel < colour.size(); ++channel) {
        const auto tint = static_cast<float>((7 * shade + 3 * static_cast<int>(channel)) % 5 - 2);
        const float light = 0.5f * static_cast<float>(shade - 2) + 0.08f * tint;
        const float value = static_cast<float>(colour[channel]) * (1.0f + contrast * light);
        entry[channel] = static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f));
      }
    }
    return made;
  }

  bool filled(Cube c) const { return world_.filled(c); }
  bool is(Cube c, CubeMaterial m) const {
    return world_.contains(c) && world_.colour_number(c) >= m.first &&
           world_.colour_number(c) < m.first + m.shades;
  }

  void fill(Cube c, CubeMaterial m) {
    if (world_.contains(c))
      world_.fill(c, static_cast<std::uint8_t>(m.first + random(c, kShade) % m.shades));
  }
  void clear(Cube c) {
    if (world_.contains(c)) world_.fill(c, 0);
  }
  /// Calls visit(cube) for those from `low` to `high`, both included.
  template <class Visit>
  static void for_box(Cube low, Cube high, const Visit& visit) {
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) visit(Cube{x, y, z});
  }
  void fill_box(Cube low, Cube high, CubeMaterial m) {
    for_box(low, high, [&](Cube c) { fill(c, m); });
  }
  void clear_box(Cube low, Cube high) {
    for_box(low, high, [&](Cube c) { clear(c); });
  }

  /// 64 random bits. Scenes number their uses from 0.
  std::uint64_t random(Cube c, int use) const {
    const std::uint64_t place = static_cast<std::uint64_t>(c.x) << 40 ^
                                static_cast<std::uint64_t>(c.y) << 20 ^
                                static_cast<std::uint64_t>(c.z);
    return mix64(mix64(seed_ + static_cast<std::uint64_t>(use + 1)) ^ place);
  }
  /// Uniform in [0, 1).
  float chance(Cube c, int use) const { return unit_float(random(c, use)); }
  /// A number from `low` to `high`, both included. Requires that low <= high.
  int pick(Cube c, int use, int low, int high) const {
    return low + static_cast<int>(random(c, use) % static_cast<std::uint64_t>(high - low + 1));
  }
  /// Different for different seeds and uses.
  NoiseField field(float width_cubes, int use) const {
    const auto along = [&](int axis) {
      return static_cast<float>(random({axis, 0, 0}, use) % 2048);
    };
    return {width_cubes, {along(0), along(1), along(2)}};
  }

 private:
  static constexpr int kShade = -1;

  World world_;
  std::uint64_t seed_;
  std::uint8_t next_ = 1;
};

/// The middle of a cube.
inline Vec3 middle_of(Cube c) {
  return Vec3{static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)} +
         Vec3{0.5f, 0.5f, 0.5f};
}

struct TreeMaterials {
  CubeMaterial trunk, leaves;
};

/// A tree with a round crown; `root` is the lowest cube of the trunk. Uses random numbers of `use`.
inline void plant_round_tree(WorldBuilder& builder, Cube root, int trunk_cubes, int crown_radius,
                             TreeMaterials m, int use) {
  const Cube crown{root.x, root.y + trunk_cubes + crown_radius - 1, root.z};
  const int r = crown_radius;
  WorldBuilder::for_box({-r, -r, -r}, {r, r, r}, [&](Cube d) {
    const Cube c{crown.x + d.x, crown.y + d.y, crown.z + d.z};
    const int distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
    const bool is_inside = distance2 < r * r;
    // The rim is frayed.
    const bool is_rim = distance2 <= r * r + 1 && builder.random(c, use) % 8 < 5;
    if ((is_inside || is_rim) && !builder.filled(c)) builder.fill(c, m.leaves);
  });
  builder.fill_box(root, {root.x, crown.y - 1, root.z}, m.trunk);
}

/// A fir: rings of branches that get narrower towards the top.
inline void plant_fir(WorldBuilder& builder, Cube root, int cubes, TreeMaterials m) {
  const int top = root.y + cubes;
  for (int y = root.y + 2; y <= top; ++y) {
    const int below_top = top - y;
    const int r = std::min(3, (below_top + 1) / 3 + below_top % 2);
    WorldBuilder::for_box({-r, 0, -r}, {r, 0, r}, [&](Cube d) {
      const Cube c{root.x + d.x, y, root.z + d.z};
      if (d.x * d.x + d.z * d.z <= r * r + 1 && !builder.filled(c) && (r > 0 || d.x + d.z == 0))
        builder.fill(c, m.leaves);
    });
  }
  builder.fill_box(root, {root.x, top - 1, root.z}, m.trunk);
}

/// Cubes up of a world in which the ground is the lower third.
inline int height_of_land(int size_cubes) { return std::max(16, size_cubes * 2 / 3); }

}  // namespace lanescope
