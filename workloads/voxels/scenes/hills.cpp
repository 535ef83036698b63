// SPDX-License-Identifier: MIT
// Hills with overhangs and trees about lakes, of the kind that the article's world is of.
#include <algorithm>
#include <vector>

#include "workloads/voxels/scenes/parts.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

enum Use { kRange, kHills, kCliffs, kRock, kForest, kTree };

class Hills {
 public:
  Hills(int size_cubes, std::uint64_t seed)
      : size_(size_cubes),
        builder_({size_cubes, height_of_land(size_cubes), size_cubes}, seed),
        level_(0.32f * static_cast<float>(builder_.size().y)),
        water_(static_cast<int>(level_ - 0.17f * relief())) {}

  World build() {
    measure();
    for (int z = 0; z < size_; ++z)
      for (int x = 0; x < size_; ++x) {
        raise(x, z);
        cover(x, z);
      }
    plant();
    return builder_.take();
  }

 private:
  /// Cubes between valleys and tops, about: hills of one size, and ranges of them in large worlds.
  float relief() const { return hill_cubes() + range_cubes(); }
  float hill_cubes() const { return std::min(15.0f, 0.28f * static_cast<float>(size_)); }
  float range_cubes() const { return 0.2f * static_cast<float>(size_); }

  /// Of the ground in a column, without overhangs.
  float height(int x, int z) const {
    const Vec3 p{static_cast<float>(x), 0.0f, static_cast<float>(z)};
    return level_ + range_cubes() * ranges_.at(p) + hill_cubes() * hills_.at(p, 3);
  }

  float& height_at(int x, int z) {
    return heights_[static_cast<std::size_t>((z + 1) * (size_ + 2) + x + 1)];
  }

  void measure() {
    heights_.resize(static_cast<std::size_t>((size_ + 2) * (size_ + 2)));
    for (int z = -1; z <= size_; ++z)
      for (int x = -1; x <= size_; ++x) height_at(x, z) = height(x, z);
  }

  /// Fills the ground of a column. Rock swells and recedes where there are cliffs.
  void raise(int x, int z) {
    const Vec3 place{static_cast<float>(x), 0.0f, static_cast<float>(z)};
    const float cliffs = cliffs_.at(place);
    const float swell = 1.5f + 11.0f * smooth_step(0.0f, 0.35f, cliffs);
    const float ground = height_at(x, z);
    const auto top = static_cast<int>(ground + swell);
    for (int y = 0; y <= std::max(top, 1); ++y) {
      const auto up = static_cast<float>(y);
      const bool is_sure = y < 2 || up < ground - 1.2f * swell;
      const Vec3 p{place.x, 1.3f * up, place.z};
      if (is_sure || ground - up + swell * rock_.at(p) > 0.0f) builder_.fill({x, y, z}, stone_);
    }
  }

  /// Grass, soil and such on the stone of a column, and water above it.
  void cover(int x, int z) {
    constexpr int kSoil = 4;
    int depth = 0;
    CubeMaterial beneath = soil_;
    for (int y = builder_.size().y - 1; y >= 0; --y) {
      const Cube c{x, y, z};
      if (!builder_.filled(c)) {
        depth = 0;
        if (y <= water_) builder_.fill(c, water_material_);
        continue;
      }
      if (depth == 0) {
        builder_.fill(c, surface(c));
        beneath = y <= water_ + 1 ? sand_ : is_steep(c) ? stone_ : soil_;
      } else if (depth < kSoil) {
        builder_.fill(c, beneath);
      }
      ++depth;
    }
  }

  bool is_steep(Cube c) {
    const float dx = height_at(c.x + 1, c.z) - height_at(c.x - 1, c.z);
    const float dz = height_at(c.x, c.z + 1) - height_at(c.x, c.z - 1);
    return dx * dx + dz * dz > 4.5f;
  }

  CubeMaterial surface(Cube c) {
    const int ragged = builder_.pick(c, kRock, 0, 2);
    if (c.y <= water_ + 1) return sand_;
    if (static_cast<float>(c.y - ragged) > level_ + 0.34f * relief()) return snow_;
    if (is_steep(c)) return stone_;
    return woods_.at(middle_of(c)) > 0.0f ? grass_ : meadow_;
  }

  /// A tree, or none, in each square of a grid; woods and clearings.
  void plant() {
    constexpr int kSquare = 6;
    for (int z = 0; z < size_; z += kSquare)
      for (int x = 0; x < size_; x += kSquare) {
        const Cube square{x, 0, z};
        const Cube place{x + builder_.pick(square, kTree, 1, kSquare - 1), 0,
                         z + builder_.pick(square, kTree + 1, 1, kSquare - 1)};
        const float wood = woods_.at(middle_of(place));
        if (builder_.chance(square, kTree + 2) < 0.13f + 1.5f * wood) plant_at(place);
      }
  }

  void plant_at(Cube place) {
    int y = builder_.size().y - 1;
    while (y > 0 && !builder_.filled({place.x, y, place.z})) --y;
    const Cube ground{place.x, y, place.z};
    if (!builder_.is(ground, grass_) && !builder_.is(ground, meadow_)) return;
    const Cube root{place.x, y + 1, place.z};
    const bool is_high = static_cast<float>(y) > level_ + 0.12f * relief();
    if (is_high)
      plant_fir(builder_, root, builder_.pick(root, kTree + 3, 5, 9), fir_);
    else
      plant_round_tree(builder_, root, builder_.pick(root, kTree + 3, 2, 3),
                       builder_.pick(root, kTree + 4, 2, 3), broadleaf_, kTree + 5);
  }

  const int size_;
  WorldBuilder builder_;
  const float level_;  ///< Mean height of the ground.
  const int water_;    ///< The highest cube of lakes.
  std::vector<float> heights_;

  const NoiseField ranges_ = builder_.field(0.5f * static_cast<float>(size_) + 6.0f, kRange);
  const NoiseField hills_ =
      builder_.field(std::min(25.0f, 0.55f * static_cast<float>(size_)), kHills);
  const NoiseField cliffs_ = builder_.field(19.0f, kCliffs);
  const NoiseField rock_ = builder_.field(9.0f, kRock);
  const NoiseField woods_ = builder_.field(21.0f, kForest);

  const CubeMaterial stone_ = builder_.material({128, 126, 124}, 0.09f);
  const CubeMaterial soil_ = builder_.material({128, 92, 62}, 0.09f);
  const CubeMaterial grass_ = builder_.material({96, 148, 60}, 0.08f);
  const CubeMaterial meadow_ = builder_.material({140, 172, 72}, 0.07f);
  const CubeMaterial sand_ = builder_.material({222, 204, 150}, 0.04f);
  const CubeMaterial snow_ = builder_.material({238, 242, 248}, 0.03f);
  const CubeMaterial water_material_ = builder_.material({62, 122, 178}, 0.04f);
  const TreeMaterials broadleaf_{builder_.material({98, 70, 46}, 0.07f),
                                 builder_.material({72, 122, 46}, 0.13f)};
  const TreeMaterials fir_{builder_.material({84, 62, 46}, 0.07f),
                           builder_.material({44, 92, 62}, 0.13f)};
};

World build(int size_cubes, std::uint64_t seed) { return Hills(size_cubes, seed).build(); }

}  // namespace

extern const VoxelScene v_hills = {
    .name = "hills",
    .summary = "hills with overhangs, woods and lakes",
    .build = build,
};

}  // namespace lanescope
