// SPDX-License-Identifier: MIT
// Stones and islands of different sizes that float over nothing.
#include <algorithm>
#include <array>
#include <cstdint>

#include "workloads/voxels/scenes/parts.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

enum Use { kPlace, kShape = kPlace + 3, kRough, kKind, kTree };

constexpr float kLargestRadius = 5.0f;

class Stones {
 public:
  Stones(int size_cubes, std::uint64_t seed)
      : size_(size_cubes), builder_({size_cubes, size_cubes, size_cubes}, seed) {}

  /// Three of a hundred cubes are filled, about, whatever the size.
  World build() {
    const std::int64_t wanted = std::int64_t{size_} * size_ * size_ * 3 / 100;
    for (int stone = 0; filled_ < wanted; ++stone) {
      const float radius = radius_of(stone);
      // Of a small world, one stone would be all.
      if (8.0f * radius * radius * radius > static_cast<float>(wanted)) continue;
      place(stone, radius);
    }
    return builder_.take();
  }

 private:
  /// Small ones are more frequent.
  float radius_of(int stone) const {
    const float u = builder_.chance({stone, 0, 0}, kShape);
    return 0.5f + (kLargestRadius - 0.5f) * u * u;
  }

  void place(int stone, float radius) {
    const Cube id{stone, 0, 0};
    const auto along = [&](int axis) { return builder_.pick(id, kPlace + axis, 0, size_ - 1); };
    const Cube centre{along(0), along(1), along(2)};
    if (radius > 2.5f)
      float_island(centre, radius);
    else
      float_stone(centre, radius, rocks_[builder_.random(id, kKind) % rocks_.size()]);
  }

  void fill(Cube c, CubeMaterial m) {
    const Cube size = builder_.size();
    const bool is_inside =
        c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < size.x && c.y < size.y && c.z < size.z;
    if (is_inside && !builder_.filled(c)) ++filled_;
    builder_.fill(c, m);
  }

  /// How far from the middle, in radii, with some roughness.
  float reach(Cube c, Vec3 from_centre, float radius) const {
    const float rough = roughness_.at(middle_of(c));
    return length(from_centre) / radius + 0.25f * rough;
  }

  void float_stone(Cube centre, float radius, CubeMaterial m) {
    fill(centre, m);
    const auto r = static_cast<int>(radius + 1.0f);
    WorldBuilder::for_box({-r, -r, -r}, {r, r, r}, [&](Cube d) {
      const Cube c{centre.x + d.x, centre.y + d.y, centre.z + d.z};
      const Vec3 p{static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
      if (reach(c, p, radius) < 1.0f) fill(c, m);
    });
  }

  /// Flat and green above, pointed below.
  void float_island(Cube centre, float radius) {
    const auto r = static_cast<int>(radius + 1.0f);
    WorldBuilder::for_box({-r, -2 * r, -r}, {r, 1, r}, [&](Cube d) {
      const Cube c{centre.x + d.x, centre.y + d.y, centre.z + d.z};
      const auto up = static_cast<float>(d.y);
      const float taper = d.y > 0 ? 2.6f : 0.55f;
      const Vec3 p{static_cast<float>(d.x), taper * up, static_cast<float>(d.z)};
      const float narrowed = std::max(0.5f, radius - 0.4f * std::max(0.0f, -up));
      if (reach(c, p, narrowed) < 1.0f) fill(c, d.y < -1 ? rocks_[0] : soil_);
    });
    grow(centre, r);
  }

  /// Grass where there is soil below the open, and a tree on large islands.
  void grow(Cube centre, int r) {
    WorldBuilder::for_box({-r, 0, -r}, {r, 1, r}, [&](Cube d) {
      const Cube c{centre.x + d.x, centre.y + d.y, centre.z + d.z};
      if (builder_.is(c, soil_) && !builder_.filled({c.x, c.y + 1, c.z})) fill(c, grass_);
    });
    Cube root{centre.x, centre.y, centre.z};
    while (root.y <= centre.y + 2 && builder_.filled(root)) ++root.y;
    if (r >= 5 && builder_.is({root.x, root.y - 1, root.z}, grass_)) plant(root);
  }

  void plant(Cube root) {
    plant_round_tree(builder_, root, 2, 2, tree_, kTree);
    constexpr int kTreeCubes = 30;  // About: what is said of the share of filled cubes is, too.
    filled_ += kTreeCubes;
  }

  const int size_;
  WorldBuilder builder_;
  std::int64_t filled_ = 0;
  const NoiseField roughness_ = builder_.field(3.0f, kRough);

  const std::array<CubeMaterial, 4> rocks_ = {
      builder_.material({142, 132, 124}, 0.09f), builder_.material({110, 116, 128}, 0.09f),
      builder_.material({178, 150, 116}, 0.08f), builder_.material({150, 112, 152}, 0.11f)};
  const CubeMaterial soil_ = builder_.material({130, 94, 64}, 0.09f);
  const CubeMaterial grass_ = builder_.material({110, 164, 70}, 0.08f);
  const TreeMaterials tree_{builder_.material({98, 70, 46}, 0.07f),
                            builder_.material({206, 116, 132}, 0.09f)};
};

World build(int size_cubes, std::uint64_t seed) { return Stones(size_cubes, seed).build(); }

}  // namespace

extern const VoxelScene v_stones = {
    .name = "stones",
    .summary = "stones and islands that float, 3 of a hundred cubes",
    .build = build,
};

}  // namespace lanescope
