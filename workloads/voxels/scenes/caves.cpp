// SPDX-License-Identifier: MIT
// Rock with chambers and tunnels, which open to the surface and to the sides, where it is cut.
#include <algorithm>
#include <array>

#include "workloads/voxels/scenes/parts.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

enum Use { kSurface, kTunnel, kOtherTunnel, kChamber, kFold, kOre, kOreKind, kHanging, kShaft };

class Caves {
 public:
  Caves(int size_cubes, std::uint64_t seed)
      : size_(size_cubes),
        builder_({size_cubes, height_of_land(size_cubes), size_cubes}, seed),
        lava_(std::max(1, builder_.size().y / 9)) {}

  World build() {
    for (int z = 0; z < size_; ++z)
      for (int x = 0; x < size_; ++x) raise(x, z);
    sink_shafts();
    for (int z = 0; z < size_; ++z)
      for (int x = 0; x < size_; ++x) furnish(x, z);
    return builder_.take();
  }

 private:
  int surface(int x, int z) const {
    const Vec3 p{static_cast<float>(x), 0.0f, static_cast<float>(z)};
    const auto top = static_cast<float>(builder_.size().y);
    return static_cast<int>(0.82f * top + 3.5f * surface_.at(p, 2));
  }

  void raise(int x, int z) {
    const int top = surface(x, z);
    const Vec3 column{static_cast<float>(x), 0.0f, static_cast<float>(z)};
    const float fold = 4.0f * folds_.at(column, 2);
    for (int y = 0; y <= top; ++y) {
      const Cube c{x, y, z};
      if (y < 2 || !is_hollow(middle_of(c))) builder_.fill(c, rock(c, top, fold));
    }
  }

  /// A tunnel is where two noises are near zero: surfaces, which meet in a line.
  bool is_hollow(Vec3 p) const {
    const Vec3 flat{p.x, 1.6f * p.y, p.z};
    if (chambers_.at(flat) > 0.26f) return true;
    const float a = tunnels_[0].at(flat);
    if (a * a > kTunnelWidth) return false;
    const float b = tunnels_[1].at(flat);
    return a * a + b * b < kTunnelWidth;
  }

  CubeMaterial rock(Cube c, int top, float fold) const {
    if (c.y == top) return grass_;
    if (c.y + 3 > top) return soil_;
    const Vec3 p = middle_of(c);
    if (ore_.at(p) > 0.47f) {
      const float kind = ore_kind_.at(p);
      return ores_[kind < -0.15f ? 0 : kind < 0.15f ? 1 : 2];
    }
    constexpr float kThickness = 3.5f;
    const auto stratum = static_cast<int>((p.y + fold + 64.0f) / kThickness);
    return strata_[builder_.random({0, stratum, 0}, kFold) % strata_.size()];
  }

  /// Ways down from the surface, at least one, so that light falls into the depth.
  void sink_shafts() {
    constexpr int kSquare = 40;
    const int squares = std::max(1, size_ / kSquare);
    for (int j = 0; j < squares; ++j)
      for (int i = 0; i < squares; ++i) {
        const int side = size_ / squares;
        const Cube square{i, 0, j};
        const int x = i * side + builder_.pick(square, kShaft, side / 4, side * 3 / 4);
        const int z = j * side + builder_.pick(square, kShaft + 1, side / 4, side * 3 / 4);
        sink_shaft(x, z, std::min(4, size_ / 12 + 1));
      }
  }

  void sink_shaft(int x, int z, int radius) {
    const Vec3 column{static_cast<float>(x), 0.0f, static_cast<float>(z)};
    for (int y = builder_.size().y - 1; y > builder_.size().y / 4; --y) {
      const Vec3 at = column + Vec3{0.0f, static_cast<float>(y), 0.0f};
      const float bend = static_cast<float>(radius) * 1.5f;
      const int cx = x + static_cast<int>(bend * bends_[0].at(at));
      const int cz = z + static_cast<int>(bend * bends_[1].at(at));
      for (int dz = -radius; dz <= radius; ++dz)
        for (int dx = -radius; dx <= radius; ++dx)
          if (dx * dx + dz * dz < radius * radius) builder_.clear({cx + dx, y, cz + dz});
    }
  }

  /// Lava, moss on floors, and stones that hang from ceilings or stand below.
  void furnish(int x, int z) {
    for (int y = 2; y < builder_.size().y; ++y) {
      const Cube c{x, y, z};
      if (builder_.filled(c)) continue;
      const Cube below{x, y - 1, z}, above{x, y + 1, z};
      const bool has_roof = builder_.filled(above) && !builder_.is(above, lava_material_);
      if (y <= lava_)
        builder_.fill(c, lava_material_);
      else if (has_roof && builder_.chance(c, kHanging) < 0.09f)
        hang(c, builder_.pick(c, kHanging + 1, 1, 3));
      else if (is_floor(below) && builder_.chance(c, kHanging + 2) < 0.25f)
        builder_.fill(below, moss_);
    }
  }

  bool is_floor(Cube c) const {
    return builder_.filled(c) && !builder_.is(c, lava_material_) && !builder_.is(c, grass_) &&
           !builder_.is(c, dripstone_);
  }

  void hang(Cube c, int cubes) {
    for (int i = 0; i < cubes && c.y - i > lava_ && !builder_.filled({c.x, c.y - i, c.z}); ++i)
      builder_.fill({c.x, c.y - i, c.z}, dripstone_);
  }

  static constexpr float kTunnelWidth = 0.018f;

  const int size_;
  WorldBuilder builder_;
  const int lava_;  ///< The highest cube of the pools.

  const NoiseField surface_ = builder_.field(21.0f, kSurface);
  const NoiseField folds_ = builder_.field(34.0f, kFold);
  const NoiseField chambers_ = builder_.field(20.0f, kChamber);
  const std::array<NoiseField, 2> tunnels_ = {builder_.field(20.0f, kTunnel),
                                              builder_.field(20.0f, kOtherTunnel)};
  const std::array<NoiseField, 2> bends_ = {builder_.field(12.0f, kShaft),
                                            builder_.field(12.0f, kShaft + 1)};
  const NoiseField ore_ = builder_.field(4.0f, kOre);
  const NoiseField ore_kind_ = builder_.field(13.0f, kOreKind);

  const CubeMaterial grass_ = builder_.material({104, 156, 66}, 0.08f);
  const CubeMaterial soil_ = builder_.material({126, 90, 60}, 0.09f);
  const CubeMaterial moss_ = builder_.material({98, 128, 88}, 0.09f);
  const CubeMaterial dripstone_ = builder_.material({196, 178, 150}, 0.07f);
  const CubeMaterial lava_material_ = builder_.material({246, 124, 40}, 0.11f);
  const std::array<CubeMaterial, 5> strata_ = {
      builder_.material({150, 138, 126}, 0.06f), builder_.material({176, 140, 108}, 0.06f),
      builder_.material({120, 116, 122}, 0.06f), builder_.material({164, 112, 88}, 0.06f),
      builder_.material({196, 176, 144}, 0.06f)};
  const std::array<CubeMaterial, 3> ores_ = {builder_.material({52, 50, 56}, 0.11f),
                                             builder_.material({90, 190, 200}, 0.14f),
                                             builder_.material({232, 192, 72}, 0.11f)};
};

World build(int size_cubes, std::uint64_t seed) { return Caves(size_cubes, seed).build(); }

}  // namespace

extern const VoxelScene v_caves = {
    .name = "caves",
    .summary = "rock with chambers and tunnels, cut at its sides",
    .build = build,
};

}  // namespace lanescope
