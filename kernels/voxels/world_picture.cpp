// SPDX-License-Identifier: MIT
#include "kernels/voxels/world_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "simulator/base/error.h"
#include "workloads/geometry/vector.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

constexpr int kWidthPx = 960;
constexpr int kHeightPx = 600;
constexpr float kPi = std::numbers::pi_v<float>;

/// Samples of a pixel: where in it, and where on the disc of the sun their shadow ray ends. No two
/// share a row or a column.
struct Sample {
  float x, y;
  float sun_x, sun_y;
};
constexpr std::array<Sample, 4> kSamples{{{0.375f, 0.125f, -0.4f, 0.9f},
                                          {0.875f, 0.375f, 0.9f, 0.4f},
                                          {0.125f, 0.625f, -0.9f, -0.4f},
                                          {0.625f, 0.875f, 0.4f, -0.9f}}};

// Linear light, as a white surface that it falls on shows it.
const Vec3 kToSun = normalized({-0.58f, 0.80f, 0.42f});
constexpr float kSunRadius = 0.012f;
constexpr Vec3 kSun{1.44f, 1.17f, 0.80f};
/// The sky's light from direction w is kSkyMean + kSkyRise w.y: light from above, and a little
/// that the ground sends back from below.
constexpr Vec3 kSkyMean{0.32f, 0.37f, 0.45f};
constexpr Vec3 kSkyRise{0.10f, 0.18f, 0.33f};
/// Where cubes hide the sky, they send this on: no corner of a sunny day is black.
constexpr Vec3 kBounce{0.06f, 0.052f, 0.045f};

constexpr Vec3 kSkyTop{0.13f, 0.36f, 0.72f};
constexpr Vec3 kSkyBottom{0.92f, 0.94f, 0.92f};
constexpr Vec3 kHaze{0.56f, 0.74f, 0.92f};
constexpr float kMostHaze = 0.2f;

// --- The grid ------------------------------------------------------------------------------------

float& component(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
int& component(Cube& c, int axis) { return axis == 0 ? c.x : axis == 1 ? c.y : c.z; }

Vec3 to_vector(Cube c) {
  return {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
}

/// Cubes from `first` to before `end`.
struct Box {
  Cube first, end;
  bool empty() const { return first.x >= end.x || first.y >= end.y || first.z >= end.z; }
};

/// Calls `visit` with the smallest box around the filled cubes of each row of `box`, along x, that
/// has any.
template <class Visit>
void for_each_row(const World& world, const Box& box, const Visit& visit) {
  for (int z = box.first.z; z < box.end.z; ++z)
    for (int y = box.first.y; y < box.end.y; ++y) {
      int first = box.first.x, end = box.end.x;
      while (first < end && !world.filled({first, y, z})) ++first;
      while (first < end && !world.filled({end - 1, y, z})) --end;
      if (first < end) visit(Box{{first, y, z}, {end, y + 1, z + 1}});
    }
}

/// What is shown of a world, and casts shadows: within the margin are no probes, so its cubes would
/// have no light and hide those that have. All of the world, if it is nothing but margin.
Box shown_box(const World& world) {
  const Cube size = world.size();
  const int margin = world.margin;
  const Box inner{{margin, margin, margin}, {size.x - margin, size.y - margin, size.z - margin}};
  return inner.empty() ? Box{{}, size} : inner;
}

/// The smallest box with all filled cubes of `box`; empty if there are none.
Box filled_box(const World& world, const Box& box) {
  Box filled{box.end, box.first};
  for_each_row(world, box, [&](const Box& row) {
    filled.first = {std::min(filled.first.x, row.first.x), std::min(filled.first.y, row.first.y),
                    std::min(filled.first.z, row.first.z)};
    filled.end = {std::max(filled.end.x, row.end.x), std::max(filled.end.y, row.end.y),
                  std::max(filled.end.z, row.end.z)};
  });
  return filled;
}

/// A face of a cube, and where on it a ray came in.
struct Hit {
  Cube cube;
  int axis = 0;   ///< Of the normal.
  int sign = -1;  ///< The normal points along the axis, 1, or against it, -1.
  Vec3 position;
  float distance = 0.0f;

  Vec3 normal() const {
    Vec3 normal;
    component(normal, axis) = static_cast<float>(sign);
    return normal;
  }
};

/// A ray that goes from cube to cube of a box.
class Walk {
 public:
  Walk(const Box& box, Vec3 origin, Vec3 direction) : box_(box), origin_(origin), to_(direction) {
    enter();
  }

  /// The first filled cube from where the walk is, if any.
  std::optional<Hit> to_filled(const World& world) {
    while (inside_) {
      if (world.colour_number(cube_) != 0) return hit();
      step();
    }
    return std::nullopt;
  }

 private:
  static constexpr float kNever = std::numeric_limits<float>::infinity();

  /// Finds the first cube of the box, and for each axis the distances to the faces that are next.
  void enter() {
    float leave = kNever;
    for (int axis = 0; axis < 3; ++axis) {
      const float o = component(origin_, axis), d = component(to_, axis);
      const auto low = static_cast<float>(component(box_.first, axis));
      const auto high = static_cast<float>(component(box_.end, axis));
      if (d == 0.0f) {
        if (o < low || o >= high) return;
        continue;
      }
      const float near = ((d > 0.0f ? low : high) - o) / d;
      leave = std::min(leave, ((d > 0.0f ? high : low) - o) / d);
      if (near > distance_) {
        distance_ = near;
        axis_ = axis;
      }
    }
    if (!(distance_ < leave)) return;
    for (int axis = 0; axis < 3; ++axis) enter_along(axis);
    inside_ = true;
  }

  void enter_along(int axis) {
    const float d = component(to_, axis);
    const float place = component(origin_, axis) + distance_ * d;
    const auto cube = static_cast<int>(std::floor(place));
    component(cube_, axis) =
        std::clamp(cube, component(box_.first, axis), component(box_.end, axis) - 1);
    step_[axis] = d > 0.0f ? 1 : -1;
    between_[axis] = d == 0.0f ? kNever : std::abs(1.0f / d);
    const int face = component(cube_, axis) + (d > 0.0f ? 1 : 0);
    next_[axis] = d == 0.0f ? kNever : (static_cast<float>(face) - component(origin_, axis)) / d;
    last_[axis] = d > 0.0f ? component(box_.end, axis) : component(box_.first, axis) - 1;
  }

  void step() {
    axis_ = next_[0] < next_[1] ? (next_[0] < next_[2] ? 0 : 2) : (next_[1] < next_[2] ? 1 : 2);
    distance_ = next_[axis_];
    next_[axis_] += between_[axis_];
    int& place = component(cube_, axis_);
    place += step_[axis_];
    inside_ = place != last_[axis_];
  }

  Hit hit() const { return {cube_, axis_, -step_[axis_], origin_ + distance_ * to_, distance_}; }

  Box box_;
  Vec3 origin_, to_;
  Cube cube_;
  int step_[3] = {}, last_[3] = {};       ///< The next cube, and the first beyond the box.
  float between_[3] = {}, next_[3] = {};  ///< Distances from face to face, and to the next.
  float distance_ = 0.0f;
  int axis_ = 1;
  bool inside_ = false;
};

// --- The camera ----------------------------------------------------------------------------------

/// Looks down on a corner of the world from a distance at which all that is filled is in view.
class Camera {
 public:
  Camera(const World& world, const Box& box) {
    // A point p is in view if dot(p - eye, side) <= 0 for each of the four sides of the pyramid, of
    // which these are the normals. How far the world reaches along them gives the eye: the nearest
    // from which no side cuts the world.
    const float up_scale = kAcross * kHeightPx / kWidthPx;
    const float wide = kAcross * (1.0f - kFrame), high = up_scale * (1.0f - kFrame);
    const std::array<Vec3, 4> sides{right_ - wide * ahead_, -right_ - wide * ahead_,
                                    up_ - high * ahead_, -up_ - high * ahead_};
    const auto [right, left, top, bottom] = reaches(world, box, sides);
    const float back = std::max((right + left) / (2.0f * wide), (top + bottom) / (2.0f * high));
    eye_ = 0.5f * (right - left) * right_ + 0.5f * (top - bottom) * up_ - back * ahead_;
    across_ = kAcross * right_;
    upward_ = up_scale * up_;
  }

  Vec3 eye() const { return eye_; }

  /// Unit direction through a place of the picture, in pixels from its top left corner.
  Vec3 through(float x, float y) const {
    const float u = 2.0f * x / kWidthPx - 1.0f, v = 1.0f - 2.0f * y / kHeightPx;
    return normalized(ahead_ + u * across_ + v * upward_);
  }

 private:
  static constexpr float kAcross = 0.30f;  ///< Tangent of half the angle of view.
  static constexpr float kFrame = 0.05f;   ///< Of the picture is left free on each side.

  /// For each direction the greatest dot(p, direction) of the points p of filled cubes.
  static std::array<float, 4> reaches(const World& world, const Box& box,
                                      const std::array<Vec3, 4>& directions) {
    std::array<float, 4> reaches;
    reaches.fill(-std::numeric_limits<float>::infinity());
    for_each_row(world, box, [&](const Box& row) {
      const Vec3 first = to_vector(row.first), end = to_vector(row.end);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3 d = directions[i];
        const Vec3 p{d.x > 0.0f ? end.x : first.x, d.y > 0.0f ? end.y : first.y,
                     d.z > 0.0f ? end.z : first.z};
        reaches[i] = std::max(reaches[i], dot(p, d));
      }
    });
    return reaches;
  }

  const Vec3 ahead_ = normalized({-0.66f, -0.62f, -0.76f});
  const Vec3 right_ = normalized(cross(ahead_, {0.0f, 1.0f, 0.0f}));
  const Vec3 up_ = cross(right_, ahead_);
  Vec3 eye_, across_, upward_;
};

// --- Harmonics -----------------------------------------------------------------------------------

/// The function a + dot(b, w) of unit vectors w.
struct Linear {
  float a = 0.0f;
  Vec3 b;
};

Linear operator+(const Linear& f, const Linear& g) { return {f.a + g.a, f.b + g.b}; }
Linear operator*(float s, const Linear& f) { return {s * f.a, s * f.b}; }

Linear to_linear(const Harmonics& h) {
  const float order_0 = std::sqrt(1.0f / (4.0f * kPi)), order_1 = std::sqrt(3.0f / (4.0f * kPi));
  return {order_0 * h[0], order_1 * Vec3{h[1], h[2], h[3]}};
}

/// Order 0 and 1 of what a face sees that nothing hides the sky from: half the sphere.
Linear open_half(Vec3 normal) { return {0.5f, 0.75f * normal}; }

/// The numbers of the probes, by their corners.
class ProbeNumbers {
 public:
  explicit ProbeNumbers(const VoxelSource& source)
      : size_(source.world()->size()),
        columns_(static_cast<std::size_t>(size_.x + 1) * static_cast<std::size_t>(size_.z + 1) + 1),
        probes_(source.probe_count()) {
    source.for_each_probe([&](Cube c, std::uint64_t) { ++columns_[column(c) + 1]; });
    for (std::size_t i = 1; i < columns_.size(); ++i) columns_[i] += columns_[i - 1];
    std::vector<std::uint64_t> next = columns_;
    source.for_each_probe([&](Cube c, std::uint64_t number) {
      probes_[next[column(c)]++] = {c.y, number};
    });
    for (std::size_t i = 1; i < columns_.size(); ++i)
      std::sort(at(columns_[i - 1]), at(columns_[i]), below);
  }

  std::optional<std::uint64_t> find(Cube corner) const {
    const auto first = probes_.begin() + static_cast<std::ptrdiff_t>(columns_[column(corner)]);
    const auto end = probes_.begin() + static_cast<std::ptrdiff_t>(columns_[column(corner) + 1]);
    const auto found = std::lower_bound(first, end, Entry{corner.y, 0}, below);
    if (found == end || found->y != corner.y) return std::nullopt;
    return found->number;
  }

 private:
  struct Entry {
    int y;
    std::uint64_t number;
  };

  static bool below(const Entry& a, const Entry& b) { return a.y < b.y; }

  std::size_t column(Cube c) const {
    return static_cast<std::size_t>(c.z) * static_cast<std::size_t>(size_.x + 1) +
           static_cast<std::size_t>(c.x);
  }
  std::vector<Entry>::iterator at(std::uint64_t place) {
    return probes_.begin() + static_cast<std::ptrdiff_t>(place);
  }

  Cube size_;
  std::vector<std::uint64_t> columns_;  ///< Where each column begins in probes_, and the last ends.
  std::vector<Entry> probes_;           ///< By column, then y.
};

/// Visibility of the sky anywhere on the faces of a world: its harmonics at the corners of a face,
/// interpolated.
class Visibility {
 public:
  Visibility(const World& world, const ProbeField& field)
      : source_(std::shared_ptr<const World>(std::shared_ptr<void>(), &world)),
        numbers_(source_),
        field_(field) {
    LANESCOPE_CHECK(field.probes().size() == source_.probe_count(), "{} probes of {}",
                    field.probes().size(), source_.probe_count());
  }

  Linear at(const Hit& hit) const {
    // Corners 0 to 3 are along `u`, then along `v`.
    const int u = (hit.axis + 1) % 3, v = (hit.axis + 2) % 3;
    Cube base = hit.cube;
    if (hit.sign > 0) ++component(base, hit.axis);
    Vec3 from_base = hit.position - to_vector(base);
    const float s = saturate(component(from_base, u)), t = saturate(component(from_base, v));
    const std::array<float, 4> weights{(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
    Linear sum;
    float found = 0.0f;
    for (int i = 0; i < 4; ++i) {
      Cube corner = base;
      component(corner, u) += i & 1;
      component(corner, v) += i >> 1;
      const auto number = numbers_.find(corner);
      if (!number) continue;
      // A weight that is never 0: without probes at other corners, the nearest is all there is.
      const float weight = std::max(weights[static_cast<std::size_t>(i)], 1e-6f);
      sum = sum + weight * to_linear(field_.probes()[*number]);
      found += weight;
    }
    // Only worlds with a margin have corners without a probe, where the margin begins. With none at
    // all, nothing is known to hide the sky.
    return found == 0.0f ? open_half(hit.normal()) : 1.0f / found * sum;
  }

 private:
  VoxelSource source_;
  ProbeNumbers numbers_;
  const ProbeField& field_;
};

/// What a white surface reflects of the sky: its visible part, convolved with the cosine that is
/// clamped to the side of the normal, over pi.
Vec3 ambient(const Linear& visible, Vec3 normal) {
  // Sky where it is visible and kBounce elsewhere: kBounce + visible (sky - kBounce). That product
  // of linear functions has a part of order 2; only orders 0 and 1 are kept.
  const Vec3 mean = kSkyMean - kBounce;
  const Vec3 order_0 = kBounce + visible.a * mean + visible.b.y / 3.0f * kSkyRise;
  const Vec3 order_1 = visible.a * normal.y * kSkyRise + dot(visible.b, normal) * mean;
  const Vec3 light = order_0 + 2.0f / 3.0f * order_1;  // Convolved: pi and 2 pi / 3, over pi.
  return {std::max(light.x, 0.0f), std::max(light.y, 0.0f), std::max(light.z, 0.0f)};
}

// --- The pictures --------------------------------------------------------------------------------

Vec3 squared(Vec3 v) { return v * v; }

/// Nears 1 instead of clipping, so that snow in the sun has edges.
float soft(float x) { return x < 0.7f ? x : 1.0f - 0.09f / (x - 0.4f); }
Vec3 soft(Vec3 v) { return {soft(v.x), soft(v.y), soft(v.z)}; }

Vec3 sky_at(float y) { return mix(kSkyTop, kSkyBottom, smooth_step(-0.1f, 1.05f, y / kHeightPx)); }

class Painter {
 public:
  Painter(const World& world, const ProbeField& field, Shown shown)
      : world_(world),
        shown_(shown),
        box_(filled_box(world, shown_box(world))),
        visibility_(world, field) {
    if (box_.empty()) return;
    camera_.emplace(world, box_);
    measure_depth();
  }

  /// Linear light of a sample of the picture.
  Vec3 paint(float x, float y, const Sample& sample) const {
    const Vec3 sky = sky_at(y);
    if (!camera_) return sky;
    const auto hit = Walk(box_, camera_->eye(), camera_->through(x, y)).to_filled(world_);
    return hit ? shade(*hit, sample) : sky;
  }

 private:
  /// The distances of the nearest and the farthest corner of the box, between which haze grows.
  void measure_depth() {
    near_ = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner =
          to_vector({i & 1 ? box_.end.x : box_.first.x, i & 2 ? box_.end.y : box_.first.y,
                     i & 4 ? box_.end.z : box_.first.z});
      const float distance = length(corner - camera_->eye());
      near_ = std::min(near_, distance);
      far_ = std::max(far_, distance);
    }
  }

  Vec3 shade(const Hit& hit, const Sample& sample) const {
    const Vec3 normal = hit.normal();
    if (shown_ == Shown::kCubes) return squared(displayed_albedo(hit.cube) * face_factor(hit));
    const Linear visible = visibility_.at(hit);
    if (shown_ == Shown::kOcclusion) return saturate(visible.a) * Vec3{1.0f, 1.0f, 1.0f};
    Vec3 light = ambient(visible, normal);
    if (shown_ == Shown::kAmbient) return kAmbientExposure * light;
    light = light + sun(hit, normal, sample);
    if (shown_ == Shown::kLighting) return soft(kLightingExposure * light);
    const float depth = saturate((hit.distance - near_) / (far_ - near_));
    return mix(soft(squared(displayed_albedo(hit.cube)) * light), kHaze, kMostHaze * depth * depth);
  }

  Vec3 displayed_albedo(Cube cube) const {
    const World::Colour& colour = world_.colour(cube);
    return Vec3{static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                static_cast<float>(colour[2])} *
           (1.0f / 255.0f);
  }

  /// Without light, faces must differ for a cube to be seen as one.
  static float face_factor(const Hit& hit) {
    constexpr std::array<float, 3> kAlong{0.66f, 1.0f, 0.83f};
    return kAlong[static_cast<std::size_t>(hit.axis)] *
           (hit.axis == 1 && hit.sign < 0 ? 0.5f : 1.0f);
  }

  Vec3 sun(const Hit& hit, Vec3 normal, const Sample& sample) const {
    const Vec3 side = normalized(cross(kToSun, {0.0f, 1.0f, 0.0f}));
    const Vec3 to_sun = normalized(kToSun + kSunRadius * sample.sun_x * side +
                                   kSunRadius * sample.sun_y * cross(side, kToSun));
    const float facing = dot(normal, to_sun);
    if (facing <= 0.0f) return {};
    // From a little above the face, so that it does not shade itself.
    const Vec3 origin = hit.position + 1e-3f * normal;
    return Walk(box_, origin, to_sun).to_filled(world_) ? Vec3{} : facing * kSun;
  }

  static constexpr float kAmbientExposure = 1.35f;
  static constexpr float kLightingExposure = 0.72f;

  const World& world_;
  Shown shown_;
  Box box_;
  Visibility visibility_;
  std::optional<Camera> camera_;
  float near_ = 0.0f, far_ = 0.0f;
};

std::uint8_t displayed(float linear) {
  return static_cast<std::uint8_t>(std::lround(std::sqrt(saturate(linear)) * 255.0f));
}

}  // namespace

Raster draw_world(const World& world, const ProbeField& field, Shown shown) {
  const Painter painter(world, field, shown);
  Raster raster;
  raster.width_px = kWidthPx;
  raster.height_px = kHeightPx;
  raster.pixels.reserve(std::size_t{kWidthPx} * kHeightPx);
  for (int y = 0; y < kHeightPx; ++y)
    for (int x = 0; x < kWidthPx; ++x) {
      Vec3 light;
      for (const Sample& sample : kSamples) {
        const Vec3 one = painter.paint(static_cast<float>(x) + sample.x,
                                       static_cast<float>(y) + sample.y, sample);
        light = light + Vec3{saturate(one.x), saturate(one.y), saturate(one.z)};
      }
      light = light * (1.0f / kSamples.size());
      raster.pixels.push_back({displayed(light.x), displayed(light.y), displayed(light.z)});
    }
  return raster;
}

}  // namespace lanescope
