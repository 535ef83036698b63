// SPDX-License-Identifier: MIT
#include "workloads/geometry/triangulation.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace lanescope {
namespace {

struct Point2 {
  double x, y;
};

/// Twice the area of a triangle: positive if it is counterclockwise.
double twice_area(Point2 a, Point2 b, Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's normal, as long as twice the area. From the first corner, since coordinates may be
/// large.
Point3 normal_of(std::span<const Point3> polygon) {
  Point3 normal;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    normal = normal + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return normal;
}

/// The polygon in its plane, counterclockwise, from its first corner. Requires a finite normal that
/// is not zero.
std::vector<Point2> flattened(std::span<const Point3> polygon, Point3 normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const Point3 least = x <= y && x <= z ? Point3{1, 0, 0}
                       : y <= z         ? Point3{0, 1, 0}
                                        : Point3{0, 0, 1};
  Point3 u = cross(least, normal);
  u = u * (1.0 / std::sqrt(dot(u, u)));
  const Point3 v = cross(normal, u) * (1.0 / std::sqrt(dot(normal, normal)));
  std::vector<Point2> points;
  for (const Point3& p : polygon)
    points.push_back({dot(p - polygon[0], u), dot(p - polygon[0], v)});
  return points;
}

/// Clips ears off a ring of corners (Meisters 1975): a corner whose triangle holds no other; first
/// the one that is cut off by the shortest line, so that few triangles are long and thin. Takes
/// n * r steps at most for n corners, r of them reflex: a clipped ear changes its neighbours only.
class EarClipping {
 public:
  explicit EarClipping(std::vector<Point2> points)
      : points_(std::move(points)),
        next_(points_.size()),
        previous_(points_.size()),
        ear_(points_.size()),
        is_reflex_(points_.size()) {
    const auto n = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < n; ++i) next_[i] = (i + 1) % n, previous_[i] = (i + n - 1) % n;
    for (std::uint32_t i = 0; i < n; ++i) {
      is_reflex_[i] = !is_convex(i);
      if (is_reflex_[i]) reflex_by_x_.push_back(i);
    }
    std::sort(reflex_by_x_.begin(), reflex_by_x_.end(),
              [this](auto a, auto b) { return points_[a].x < points_[b].x; });
  }

  void run(std::vector<PolygonTriangle>& triangles) {
    find_ears();
    std::uint32_t some = 0;  // Of the ring.
    for (std::size_t left = points_.size(); left > 2; --left) {
      const std::uint32_t corner = next_ear(some);
      triangles.push_back({previous_[corner], corner, next_[corner]});
      some = next_[corner];
      clip(corner);
    }
  }

 private:
  bool is_convex(std::uint32_t i) const {
    return twice_area(points_[previous_[i]], points_[i], points_[next_[i]]) > 0.0;
  }

  /// The squared length of the line that cuts a corner off.
  double cut2(std::uint32_t i) const {
    const Point2 a = points_[previous_[i]], b = points_[next_[i]];
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  }

  bool is_ear(std::uint32_t corner) const {
    if (!is_convex(corner)) return false;
    const Point2 a = points_[previous_[corner]], b = points_[corner], c = points_[next_[corner]];
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [low, high] = std::minmax({a.y, b.y, c.y});
    auto i = std::lower_bound(reflex_by_x_.begin(), reflex_by_x_.end(), left,
                              [this](auto r, double x) { return points_[r].x < x; });
    for (; i != reflex_by_x_.end() && points_[*i].x <= right; ++i) {
      const Point2 p = points_[*i];
      if (!is_reflex_[*i] || p.y < low || p.y > high) continue;
      if (equal(p, a) || equal(p, b) || equal(p, c)) continue;
      if (twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0)
        return false;
    }
    return true;
  }

  static bool equal(Point2 a, Point2 b) { return a.x == b.x && a.y == b.y; }

  void find_ears() {
    for (std::uint32_t i = 0; i < points_.size(); ++i) judge(i);
  }

  void judge(std::uint32_t corner) {
    ear_[corner] = is_ear(corner);
    if (ear_[corner]) ears_.push({-cut2(corner), corner});
  }

  /// An ear; where rounding or a crossing leaves none, a corner of the ring.
  std::uint32_t next_ear(std::uint32_t some) {
    for (; !ears_.empty(); ears_.pop()) {
      const auto [shortness, corner] = ears_.top();
      if (ear_[corner] && shortness == -cut2(corner)) return corner;
    }
    return some;
  }

  void clip(std::uint32_t corner) {
    const std::uint32_t before = previous_[corner], after = next_[corner];
    next_[before] = after;
    previous_[after] = before;
    ear_[corner] = is_reflex_[corner] = false;
    for (const std::uint32_t i : {before, after}) {
      is_reflex_[i] = is_reflex_[i] && !is_convex(i);
      judge(i);
    }
  }

  std::vector<Point2> points_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<char> ear_;  ///< Whether a corner of the ring is one.
  std::vector<char> is_reflex_;
  std::vector<std::uint32_t> reflex_by_x_;  ///< Those that were so at first.
  /// The shortest cut first; with some that are ears no longer, or have another cut by now.
  std::priority_queue<std::pair<double, std::uint32_t>> ears_;
};

/// Whether no triangle of the fan turns the wrong way, by more than rounding can make it.
bool fan_fits(std::span<const Point3> polygon, Point3 normal) {
  constexpr double kRounding = 1e-6;  // Of the polygon's area.
  const double least = -kRounding * dot(normal, normal);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point3 part = cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    if (!(dot(part, normal) >= least)) return false;
  }
  return true;
}

}  // namespace

void triangulate(std::span<const Point3> polygon, std::vector<PolygonTriangle>& triangles) {
  triangles.clear();
  const Point3 normal = normal_of(polygon);
  const double size2 = dot(normal, normal);
  const bool flat = !(size2 > 0.0) || !std::isfinite(size2);
  if (flat || polygon.size() == 3 || fan_fits(polygon, normal)) {
    for (std::uint32_t i = 2; i < polygon.size(); ++i) triangles.push_back({0, i - 1, i});
    return;
  }
  EarClipping(flattened(polygon, normal)).run(triangles);
}

}  // namespace lanescope
