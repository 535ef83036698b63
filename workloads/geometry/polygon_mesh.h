// SPDX-License-Identifier: MIT
// A mesh as a file has it: polygons, with coordinates that keep every digit of the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "workloads/geometry/vector.h"

namespace lanescope {

/// A point before its mesh is centred: map coordinates have more digits than a float.
struct Point3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

constexpr Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point3 operator*(Point3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr bool operator==(Point3 a, Point3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
constexpr double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// What a reader returns, whatever the format: every index has been checked.
struct PolygonMesh {
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Corner {
    std::uint32_t vertex = 0;      ///< An index into positions.
    std::uint32_t normal = kNone;  ///< An index into normals, or kNone.
  };

  std::vector<Point3> positions;  ///< Finite.
  std::vector<Vec3> normals;      ///< Unit vectors, those that a corner has.
  std::vector<Corner> corners;    ///< Of all faces, one face after another.
  /// For each face, the end of its corners; those of the first begin at 0. A face has at least
  /// three corners, and no two that follow each other have the same vertex.
  std::vector<std::size_t> face_ends;
  /// What was skipped or replaced: sentences that begin with the file.
  std::vector<std::string> notes;
};

}  // namespace lanescope
