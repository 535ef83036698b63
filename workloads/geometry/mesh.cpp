// SPDX-License-Identifier: MIT
#include "workloads/geometry/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/base/error.h"
#include "workloads/geometry/obj_reader.h"
#include "workloads/geometry/triangulation.h"
#include "workloads/geometry/whole_file.h"

namespace lanescope {
namespace {

using IndexedTriangle = std::array<PolygonMesh::Corner, 3>;

/// More would have more patches than can be counted.
constexpr std::size_t kMaxTriangles = std::numeric_limits<int>::max() / 3;

Vec3 rounded(Point3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

struct Extent {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Point3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};

  void add(Point3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  double widest() const {
    const Point3 size = high - low;
    return std::max({size.x, size.y, size.z});
  }
};

/// Moves and scales positions so that those that faces use are in the unit sphere.
void normalize_positions(PolygonMesh& mesh, std::string_view path) {
  std::vector<bool> is_used(mesh.positions.size());
  Extent extent;
  for (const PolygonMesh::Corner& corner : mesh.corners) {
    is_used[corner.vertex] = true;
    extent.add(mesh.positions[corner.vertex]);
  }
  const double widest = extent.widest();
  if (!std::isfinite(widest))
    throw InputError(path, "reaches over more than {:.2g} units; scale it down",
                     std::numeric_limits<double>::max());
  if (!(widest > 0.0)) throw InputError(path, "has all vertices of its faces in one point");
  const Point3 centre = extent.low + (extent.high - extent.low) * 0.5;
  double radius2 = 0.0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point3 d = mesh.positions[i] - centre;
    mesh.positions[i] = {d.x / widest, d.y / widest, d.z / widest};
    if (is_used[i]) radius2 = std::max(radius2, dot(mesh.positions[i], mesh.positions[i]));
  }
  for (Point3& p : mesh.positions) p = p * (1.0 / std::sqrt(radius2));

  const auto unused = std::count(is_used.begin(), is_used.end(), false);
  if (unused > 0)
    mesh.notes.push_back(
        fmt::format("{}: {} of {} vertices {} used by no face and left out of view", path, unused,
                    is_used.size(), unused == 1 ? "is" : "are"));
}

std::vector<IndexedTriangle> triangles_of(const PolygonMesh& mesh, std::string_view path) {
  const std::size_t count = mesh.corners.size() - 2 * mesh.face_ends.size();
  if (count > kMaxTriangles)
    throw InputError(path, "has more than {} triangles; use fewer", kMaxTriangles);
  std::vector<IndexedTriangle> all;
  all.reserve(count);
  std::vector<Point3> polygon;
  std::vector<PolygonTriangle> triangles;
  std::size_t begin = 0;
  for (const std::size_t end : mesh.face_ends) {
    polygon.clear();
    for (std::size_t i = begin; i < end; ++i)
      polygon.push_back(mesh.positions[mesh.corners[i].vertex]);
    triangulate(polygon, triangles);
    const PolygonMesh::Corner* const corners = &mesh.corners[begin];
    for (const PolygonTriangle& t : triangles)
      all.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    begin = end;
  }
  return all;
}

/// The normal of every vertex: the average over its faces, weighted by area; zero if all of them
/// are degenerate.
std::vector<Vec3> averaged_normals(const std::vector<IndexedTriangle>& triangles,
                                   const std::vector<Vec3>& positions, std::string_view path) {
  std::vector<Vec3> normals(positions.size());
  bool any_area = false;
  for (const IndexedTriangle& t : triangles) {
    const Vec3 a = positions[t[0].vertex];
    const Vec3 twice_area = cross(positions[t[1].vertex] - a, positions[t[2].vertex] - a);
    any_area = any_area || dot(twice_area, twice_area) > 0.0f;
    for (const PolygonMesh::Corner& corner : t)
      normals[corner.vertex] = normals[corner.vertex] + twice_area;
  }
  if (!any_area) throw InputError(path, "has {} faces, all of zero area", triangles.size());
  return normals;
}

Vec3 unit_or(Vec3 v, Vec3 otherwise) {
  const float size = length(v);
  return size > 1e-20f && std::isfinite(size) ? v * (1.0f / size) : otherwise;
}

}  // namespace

TriangleMesh triangle_mesh(PolygonMesh polygons, std::string_view path) {
  normalize_positions(polygons, path);
  const std::vector<IndexedTriangle> triangles = triangles_of(polygons, path);
  std::vector<Vec3> positions;
  positions.reserve(polygons.positions.size());
  for (const Point3& p : polygons.positions) positions.push_back(rounded(p));
  const std::vector<Vec3> averages = averaged_normals(triangles, positions, path);

  TriangleMesh mesh;
  mesh.notes = std::move(polygons.notes);
  mesh.triangles.reserve(triangles.size());
  for (const IndexedTriangle& t : triangles) {
    auto& corners = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {positions[t[k].vertex], t[k].normal == PolygonMesh::kNone
                                                ? unit_or(averages[t[k].vertex], {0.0f, 1.0f, 0.0f})
                                                : polygons.normals[t[k].normal]};
  }
  return mesh;
}

TriangleMesh parse_obj(std::string_view text, std::string_view path, const MeshProgress& progress) {
  return triangle_mesh(read_obj(text, path, progress), path);
}

TriangleMesh load_mesh(const std::string& path, const MeshProgress& progress) {
  // The text is gone before the triangles are made.
  // Reading goes on; how large the file is may not be known.
  const auto goes_on = [&] {
    if (progress) progress(0.0);
  };
  PolygonMesh polygons =
      read_obj(whole_file(path, "a Wavefront OBJ file", goes_on), path, progress);
  return triangle_mesh(std::move(polygons), path);
}

}  // namespace lanescope
