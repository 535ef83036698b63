// SPDX-License-Identifier: MIT
// A town: lots between streets, with houses that have rooms, a church, markets, keeps and parks,
// and a canal with bridges.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "workloads/voxels/scenes/parts.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

constexpr int kPitch = 16;      // Cubes from lot to lot, at least.
constexpr int kHalfStreet = 2;  // Cubes from the edge of a lot to the middle of the street.
constexpr int kGround = 4;      // Cubes below a floor.
constexpr int kStorey = 4;

enum Use { kLot, kStyle, kWhere, kTree, kCrown, kCanal = kCrown + 4 };

/// Cubes from `low` to `high` of the ground, both included.
struct Area {
  int x0, z0, x1, z1;

  int width() const { return x1 - x0 + 1; }
  int depth() const { return z1 - z0 + 1; }
  Area inset(int cubes) const { return {x0 + cubes, z0 + cubes, x1 - cubes, z1 - cubes}; }
  bool is_edge(int x, int z) const { return x == x0 || x == x1 || z == z0 || z == z1; }
  bool is_corner(int x, int z) const { return (x == x0 || x == x1) && (z == z0 || z == z1); }
};

int town_height(int size_cubes) { return std::min(height_of_land(size_cubes), 40); }

class Town {
 public:
  Town(int size_cubes, std::uint64_t seed)
      : size_(size_cubes),
        lots_(std::max(1, size_cubes / kPitch)),
        builder_({size_cubes, town_height(size_cubes), size_cubes}, seed) {}

  World build() {
    pave();
    for (int j = 0; j < lots_; ++j)
      for (int i = 0; i < lots_; ++i)
        build_lot({i, 0, j}, {street(i) + kHalfStreet, street(j) + kHalfStreet,
                              street(i + 1) - kHalfStreet - 1, street(j + 1) - kHalfStreet - 1});
    if (lots_ >= 2) dig_canal(street(builder_.pick({}, kCanal, 1, lots_ - 1)));
    return builder_.take();
  }

 private:
  /// Where the middle of a street is; those at the ends are on the sides of the world.
  int street(int number) const { return size_ * number / lots_; }

  void fill(int x, int y, int z, CubeMaterial m) { builder_.fill({x, y, z}, m); }
  void slab(const Area& a, int y, CubeMaterial m) {
    builder_.fill_box({a.x0, y, a.z0}, {a.x1, y, a.z1}, m);
  }
  template <class Visit>
  static void for_area(const Area& a, const Visit& visit) {
    for (int z = a.z0; z <= a.z1; ++z)
      for (int x = a.x0; x <= a.x1; ++x) visit(x, z);
  }
  /// Upright walls about an area.
  void enclose(const Area& a, int y0, int y1, CubeMaterial wall, CubeMaterial post) {
    for_area(a, [&](int x, int z) {
      if (!a.is_edge(x, z)) return;
      builder_.fill_box({x, y0, z}, {x, y1, z}, a.is_corner(x, z) ? post : wall);
    });
  }

  void pave() {
    const Area all{0, 0, size_ - 1, size_ - 1};
    for (int y = 0; y + 1 < kGround; ++y) slab(all, y, soil_);
    slab(all, kGround - 1, cobble_);
  }

  void build_lot(Cube lot, const Area& area) {
    const bool is_middle = lots_ >= 2 && lot.x == lots_ / 2 && lot.z == lots_ / 2;
    const auto kind = builder_.random(lot, kLot) % 20;
    slab(area, kGround - 1, is_middle || kind == 17 || kind == 18 ? flags_ : grass_);
    if (is_middle || kind == 19)
      build_church(lot, area);
    else if (kind < 13 || lots_ == 1)
      build_house(lot, area);
    else if (kind < 17)
      plant_park(lot, area);
    else if (kind == 17)
      build_market(area);
    else
      build_keep(lot, area);
  }

  // Houses

  /// The part of a lot that a house stands on, along a street.
  Area footprint(Cube lot, const Area& area) const {
    const int width = std::min(area.width() - 2, builder_.pick(lot, kWhere, 7, 11));
    const int depth = std::min(area.depth() - 2, builder_.pick(lot, kWhere + 1, 6, 9));
    const int x0 = area.x0 + 1 + builder_.pick(lot, kWhere + 2, 0, area.width() - 2 - width);
    const int z0 = area.z0 + 1 + builder_.pick(lot, kWhere + 3, 0, area.depth() - 2 - depth);
    return {x0, z0, x0 + width - 1, z0 + depth - 1};
  }

  void build_house(Cube lot, const Area& area) {
    const Area a = footprint(lot, area);
    const CubeMaterial wall = plaster_[builder_.random(lot, kStyle) % plaster_.size()];
    const CubeMaterial roof = tiles_[builder_.random(lot, kStyle + 1) % tiles_.size()];
    const int most = std::clamp((builder_.size().y - kGround - 6) / kStorey, 1, 3);
    const int storeys = builder_.pick(lot, kStyle + 2, 1, most);
    for (int storey = 0; storey < storeys; ++storey)
      build_storey(a, kGround + storey * kStorey, wall, storey == 0 ? stone_ : timber_);
    open_door((a.x0 + a.x1) / 2, a.z1);
    open_door((a.x0 + a.x1) / 2 + 1, a.z0);
    const int eaves = kGround + storeys * kStorey;
    cover_with_gable(a, eaves, wall, roof);
    builder_.fill_box({a.x0 + 2, eaves, a.z0 + 1}, {a.x0 + 2, eaves + a.depth() / 2 + 2, a.z0 + 1},
                      stone_);
    plant_garden(lot, area, a);
  }

  /// Walls with windows below a floor, which is the ceiling; a wall with a way through it parts two
  /// rooms.
  void build_storey(const Area& a, int y, CubeMaterial wall, CubeMaterial post) {
    enclose(a, y, y + kStorey - 2, wall, post);
    slab(a, y + kStorey - 1, timber_);
    for_area(a, [&](int x, int z) {
      const bool is_on_x = x == a.x0 || x == a.x1;
      const int along = is_on_x ? z - a.z0 : x - a.x0;
      if (a.is_edge(x, z) && !a.is_corner(x, z) && along % 3 != 0) open_window(x, y, z, along % 3);
    });
    const int middle = (a.x0 + a.x1) / 2;
    builder_.fill_box({middle, y, a.z0 + 1}, {middle, y + kStorey - 2, a.z1 - 1}, wall);
    builder_.clear_box({middle, y, a.z0 + 2}, {middle, y + 1, a.z0 + 3});
    // A way up.
    builder_.clear_box({a.x1 - 2, y + kStorey - 1, a.z0 + 1},
                       {a.x1 - 1, y + kStorey - 1, a.z0 + 2});
  }

  void open_window(int x, int y, int z, int part) {
    if (part == 1) builder_.clear({x, y + 1, z});
    if (part == 2) fill(x, y + 1, z, shutter_);
  }

  void open_door(int x, int z) { builder_.clear_box({x, kGround, z}, {x, kGround + 1, z}); }

  /// A hollow roof that rises from the long sides to a ridge along x.
  void cover_with_gable(const Area& a, int y, CubeMaterial wall, CubeMaterial roof) {
    const Area over = a.inset(-1);
    for (int rise = 0; 2 * rise < over.depth(); ++rise) {
      const int front = over.z0 + rise, back = over.z1 - rise;
      builder_.fill_box({over.x0, y + rise, front}, {over.x1, y + rise, front}, roof);
      builder_.fill_box({over.x0, y + rise, back}, {over.x1, y + rise, back}, roof);
      for (const int x : {a.x0, a.x1})
        builder_.fill_box({x, y + rise, front + 1}, {x, y + rise, back - 1}, wall);
    }
  }

  void plant_garden(Cube lot, const Area& area, const Area& house) {
    const Area garden = area.inset(1);
    for_area(garden, [&](int x, int z) {
      const Cube root{x, kGround, z};
      const bool is_clear =
          x < house.x0 - 2 || x > house.x1 + 2 || z < house.z0 - 2 || z > house.z1 + 2;
      if (is_clear && x % 3 == 1 && z % 3 == 1 && builder_.chance(root, kTree) < 0.7f)
        plant_round_tree(builder_, root, 2, 2, tree_, kCrown);
    });
    if (builder_.random(lot, kTree) % 2 == 0) plant_hedge(area);
  }

  /// About a lot, with a gap in the middle of each side.
  void plant_hedge(const Area& area) {
    for_area(area, [&](int x, int z) {
      const bool is_gap =
          std::abs(2 * x - area.x0 - area.x1) < 4 || std::abs(2 * z - area.z0 - area.z1) < 4;
      if (area.is_edge(x, z) && !is_gap) fill(x, kGround, z, hedge_);
    });
  }

  // Lots without houses

  void plant_park(Cube lot, const Area& area) {
    plant_hedge(area);
    const Area pond = area.inset(area.width() / 3);
    slab(pond.inset(-1), kGround - 1, flags_);
    builder_.clear_box({pond.x0, kGround - 1, pond.z0}, {pond.x1, kGround - 1, pond.z1});
    slab(pond, kGround - 2, water_);
    for_area(area.inset(2), [&](int x, int z) {
      const Cube root{x, kGround, z};
      if (!builder_.is({x, kGround - 1, z}, grass_) || (x + z) % 2 != 0) return;
      if (builder_.chance(root, kTree) > 0.12f) return;
      if (builder_.random(lot, kTree) % 3 == 0)
        plant_fir(builder_, root, builder_.pick(root, kTree + 1, 6, 9), fir_);
      else
        plant_round_tree(builder_, root, builder_.pick(root, kTree + 1, 2, 4), 2, tree_, kCrown);
    });
  }

  /// An arcade about a court with a well.
  void build_market(const Area& area) {
    constexpr int kWide = 3, kTop = kGround + 4;
    const Area outer = area.inset(1), inner = outer.inset(kWide);
    for_area(outer, [&](int x, int z) {
      const bool is_court = x > inner.x0 && x < inner.x1 && z > inner.z0 && z < inner.z1;
      if (is_court) return;
      fill(x, kTop, z, tiles_[0]);
      if (!outer.is_edge(x, z) && !inner.is_edge(x, z)) fill(x, kTop + 1, z, tiles_[0]);
    });
    for (const Area& row : {outer, inner})
      for_area(row, [&](int x, int z) {
        const bool is_column = (x - row.x0) % 3 == 0 && (z - row.z0) % 3 == 0;
        if (!row.is_edge(x, z)) return;
        if (is_column || row.is_corner(x, z))
          builder_.fill_box({x, kGround, z}, {x, kTop - 1, z}, marble_);
        else
          fill(x, kTop - 1, z, marble_);
      });
    const int x = (area.x0 + area.x1) / 2, z = (area.z0 + area.z1) / 2;
    enclose({x - 1, z - 1, x + 1, z + 1}, kGround, kGround, stone_, stone_);
    fill(x, kGround, z, water_);
  }

  /// A nave with a tower before it.
  void build_church(Cube lot, const Area& area) {
    const int middle = (area.z0 + area.z1) / 2;
    const Area nave{area.x0 + 4, middle - 3, area.x1, middle + 3};
    constexpr int kNave = 6;
    slab(nave, kGround - 1, flags_);
    enclose(nave, kGround, kGround + kNave, marble_, stone_);
    for (int x = nave.x0 + 2; x < nave.x1; x += 2)
      for (const int z : {nave.z0, nave.z1})
        builder_.clear_box({x, kGround + 2, z}, {x, kGround + kNave - 2, z});
    cover_with_gable(nave, kGround + kNave, marble_, slate_);
    const Area tower{area.x0, middle - 2, area.x0 + 4, middle + 2};
    const int most = std::max(9, builder_.size().y - kGround - 8);
    build_tower(tower, std::min(most, builder_.pick(lot, kStyle, 13, 19)));
    builder_.clear_box({tower.x1, kGround, middle}, {tower.x1, kGround + 2, middle});
    builder_.clear_box({tower.x0, kGround, middle}, {tower.x0, kGround + 2, middle});
  }

  /// A belfry with a spire.
  void build_tower(const Area& a, int cubes) {
    const int top = kGround + cubes;
    enclose(a, kGround, top, marble_, stone_);
    builder_.clear_box({a.x0 + 1, kGround, a.z0 + 1}, {a.x1 - 1, top, a.z1 - 1});
    for (const int y : {kGround + 5, top - 4}) slab(a, y, stone_);
    for_area(a, [&](int x, int z) {
      const bool is_bell = (x - a.x0) % 2 == 1 || (z - a.z0) % 2 == 1;
      if (a.is_edge(x, z) && !a.is_corner(x, z) && is_bell)
        builder_.clear_box({x, top - 3, z}, {x, top - 2, z});
    });
    for (int rise = 0; rise <= 6; ++rise) {
      const Area ring = a.inset((rise + 1) / 2 - 1);
      enclose(ring, top + 1 + rise, top + 1 + rise, slate_, slate_);
    }
  }

  /// A round keep with battlements, hollow, with slits.
  void build_keep(Cube lot, const Area& area) {
    const int x = (area.x0 + area.x1) / 2, z = (area.z0 + area.z1) / 2;
    const int most = std::max(7, builder_.size().y - kGround - 4);
    const int top = kGround + std::min(most, builder_.pick(lot, kStyle, 10, 17));
    for_area({x - 4, z - 4, x + 4, z + 4}, [&](int px, int pz) {
      const int distance2 = (px - x) * (px - x) + (pz - z) * (pz - z);
      if (distance2 > 18) return;
      if (distance2 <= 9) return floor_of_keep(px, pz, top);
      builder_.fill_box({px, kGround, pz}, {px, top, pz}, stone_);
      if ((px + pz + x + z) % 2 == 0) fill(px, top + 1, pz, stone_);
      if (px == x || pz == z)
        for (int y = kGround + 3; y < top - 2; y += kStorey)
          builder_.clear_box({px, y, pz}, {px, y + 1, pz});
    });
    builder_.clear_box({x - 1, kGround, z + 3}, {x, kGround + 1, z + 4});
  }

  void floor_of_keep(int x, int z, int top) {
    for (int y = kGround + kStorey; y < top; y += kStorey) fill(x, y, z, timber_);
  }

  // The canal

  void dig_canal(int middle) {
    const int x0 = middle - kHalfStreet, x1 = middle + kHalfStreet - 1;
    builder_.clear_box({x0, 1, 0}, {x1, kGround + 1, size_ - 1});
    builder_.fill_box({x0, 1, 0}, {x1, 1, size_ - 1}, water_);
    for (const int x : {x0 - 1, x1 + 1})
      builder_.fill_box({x, 1, 0}, {x, kGround - 1, size_ - 1}, stone_);
    for (int number = 0; number <= lots_; ++number) build_bridge(x0, x1, street(number));
  }

  /// A street over the canal, on an arch, with parapets.
  void build_bridge(int x0, int x1, int middle) {
    const int z0 = middle - kHalfStreet, z1 = middle + kHalfStreet - 1;
    for (int x = x0 - 2; x <= x1 + 2; ++x) {
      const bool is_span = x > x0 && x < x1;
      const int deck = x < x0 || x > x1 ? kGround - 1 : kGround;
      const int lowest = is_span ? kGround : kGround - 1;
      builder_.fill_box({x, lowest, z0}, {x, deck, z1}, cobble_);
      for (const int z : {z0, z1}) fill(x, deck + 1, z, stone_);
    }
  }

  const int size_;
  const int lots_;  ///< Along each axis.
  WorldBuilder builder_;

  const CubeMaterial soil_ = builder_.material({118, 92, 68}, 0.08f);
  const CubeMaterial cobble_ = builder_.material({150, 144, 138}, 0.09f);
  const CubeMaterial flags_ = builder_.material({186, 174, 152}, 0.06f);
  const CubeMaterial grass_ = builder_.material({112, 158, 76}, 0.08f);
  const CubeMaterial hedge_ = builder_.material({62, 104, 54}, 0.10f);
  const CubeMaterial water_ = builder_.material({70, 128, 172}, 0.04f);
  const CubeMaterial stone_ = builder_.material({134, 130, 128}, 0.08f);
  const CubeMaterial marble_ = builder_.material({220, 208, 184}, 0.03f);
  const CubeMaterial timber_ = builder_.material({112, 78, 52}, 0.08f);
  const CubeMaterial shutter_ = builder_.material({74, 98, 106}, 0.06f);
  const CubeMaterial slate_ = builder_.material({84, 96, 116}, 0.08f);
  const std::array<CubeMaterial, 5> plaster_ = {
      builder_.material({236, 226, 204}, 0.03f), builder_.material({226, 190, 136}, 0.03f),
      builder_.material({214, 152, 124}, 0.03f), builder_.material({190, 204, 206}, 0.03f),
      builder_.material({232, 210, 150}, 0.03f)};
  const std::array<CubeMaterial, 3> tiles_ = {builder_.material({178, 82, 58}, 0.09f),
                                              builder_.material({150, 70, 56}, 0.09f),
                                              builder_.material({124, 88, 74}, 0.09f)};
  const TreeMaterials tree_{builder_.material({98, 70, 46}, 0.07f),
                            builder_.material({86, 136, 56}, 0.13f)};
  const TreeMaterials fir_{builder_.material({84, 62, 46}, 0.07f),
                           builder_.material({50, 98, 66}, 0.13f)};
};

World build(int size_cubes, std::uint64_t seed) { return Town(size_cubes, seed).build(); }

}  // namespace

extern const VoxelScene v_town = {
    .name = "town",
    .summary = "houses with rooms, a church, arcades and bridges",
    .build = build,
};

}  // namespace lanescope
