// SPDX-License-Identifier: MIT
#include "workloads/geometry/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "simulator/base/random.h"

namespace lanescope {
namespace {

using Polygon = std::vector<Point3>;

std::vector<PolygonTriangle> cut(const Polygon& polygon) {
  std::vector<PolygonTriangle> triangles{{9, 9, 9}};
  triangulate(polygon, triangles);
  return triangles;
}

/// The area on the xy plane.
double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

/// That the triangles have the polygon's area together, and none of them is turned: then they cover
/// it, once.
void expect_exact(const Polygon& polygon) {
  const std::vector<PolygonTriangle> triangles = cut(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0.0;
  for (const PolygonTriangle& t : triangles) {
    const double part = area({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    EXPECT_GE(part, -1e-6 * area(polygon));
    sum += part;
  }
  EXPECT_NEAR(sum, area(polygon), 1e-9 * area(polygon));
}

/// A star around the origin, or a polygon with many reflex corners.
Polygon radial(int corners, const std::function<double(int)>& radius) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const double r = radius(i);
    polygon.push_back({r * std::cos(angle), r * std::sin(angle), 0.0});
  }
  return polygon;
}

TEST(Triangulation, ConvexPolygonsAreFans) {
  const std::vector<PolygonTriangle> triangles = cut(radial(300, [](int) { return 1.0; }));
  ASSERT_EQ(triangles.size(), 298u);
  for (std::uint32_t i = 0; i < 298; ++i)
    EXPECT_EQ(triangles[i], (PolygonTriangle{0, i + 1, i + 2}));
}

TEST(Triangulation, ConcavePolygonsAreCoveredOnce) {
  expect_exact(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  expect_exact({{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}});  // A quadrilateral, an arrow.
  expect_exact({{2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}, {0, 0, 0}});
  // A hole, with a bridge to the outline that leads there and back.
  expect_exact({{0, 0, 0},
                {1, 1, 0},
                {1, 2, 0},
                {2, 2, 0},
                {2, 1, 0},
                {1, 1, 0},
                {0, 0, 0},
                {3, 0, 0},
                {3, 3, 0},
                {0, 3, 0}});
  expect_exact(radial(10, [](int i) { return i % 2 ? 1.0 : 0.4; }));
  Polygon spiral;
  for (int i = 0; i < 100; ++i)
    spiral.push_back({(2 + 0.1 * i) * std::cos(0.2 * i), (2 + 0.1 * i) * std::sin(0.2 * i), 0});
  for (int i = 99; i >= 0; --i)
    spiral.push_back({(1.5 + 0.1 * i) * std::cos(0.2 * i), (1.5 + 0.1 * i) * std::sin(0.2 * i), 0});
  expect_exact(spiral);
}

/// Random outlines, some with corners in the middle of edges, from any first corner.
TEST(Triangulation, RandomPolygonsAreCoveredOnce) {
  std::uint64_t state = 1;
  const auto random = [&](std::uint64_t n) { return (state = mix64(state)) % n; };
  for (int k = 0; k < 2000; ++k) {
    Polygon outline = radial(3 + static_cast<int>(random(20)),
                             [&](int) { return 1.0 + static_cast<double>(random(5)); });
    std::rotate(outline.begin(), outline.begin() + static_cast<long>(random(outline.size())),
                outline.end());
    Polygon polygon;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      polygon.push_back(outline[i]);
      if (random(3) == 0) polygon.push_back((outline[i] + outline[(i + 1) % outline.size()]) * 0.5);
    }
    expect_exact(polygon);
  }
}

/// In every plane and far from the origin.
TEST(Triangulation, DoesNotDependOnPlaceAndPlane) {
  const Polygon flat = radial(12, [](int i) { return i % 3 ? 1.0 : 0.3; });
  Polygon other;
  for (const Point3 p : flat) other.push_back({5e5 + p.y, 2.0 * p.x + p.y - 4e6, 1e5 + p.x});
  EXPECT_EQ(cut(flat).size(), 10u);
  const Point3 axis{2, 1, 1};
  for (const PolygonTriangle& t : cut(other))
    EXPECT_NE(dot(cross(other[t[1]] - other[t[0]], other[t[2]] - other[t[0]]), axis), 0.0);
  double sum = 0.0;
  for (const PolygonTriangle& t : cut(other)) sum += area({flat[t[0]], flat[t[1]], flat[t[2]]});
  EXPECT_NEAR(sum, area(flat), 1e-6);
}

TEST(Triangulation, CrossingAndEmptyPolygonsGetTriangles) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
  EXPECT_EQ(cut(Polygon(7, Point3{1, 2, 3})).size(), 5u);
  Polygon random;
  for (std::uint64_t i = 0; i < 3000; ++i)
    random.push_back({unit_float(mix64(i)), unit_float(mix64(i + 5000)), 0});
  EXPECT_EQ(cut(random).size(), 2998u);
}

}  // namespace
}  // namespace lanescope
