// SPDX-License-Identifier: MIT
#include "workloads/geometry/mesh.h"

#include <tiny_obj_loader.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "simulator/base/error.h"
#include "workloads/geometry/obj_check.h"

namespace lanescope {
namespace {

/// One corner of a triangle as indices into the loader's arrays; no normal is -1.
using IndexedTriangle = std::array<tinyobj::index_t, 3>;

std::vector<IndexedTriangle> fans(const std::vector<tinyobj::shape_t>& shapes) {
  std::vector<IndexedTriangle> triangles;
  for (const tinyobj::shape_t& shape : shapes) {
    std::size_t first = 0;
    for (const std::size_t corners : shape.mesh.num_face_vertices) {
      const auto* face = &shape.mesh.indices[first];
      for (std::size_t i = 2; i < corners; ++i)
        triangles.push_back({face[0], face[i - 1], face[i]});
      first += corners;
    }
  }
  return triangles;
}

Vec3 vector_at(const std::vector<float>& values, int index) {
  const auto i = 3 * static_cast<std::size_t>(index);
  return {values[i], values[i + 1], values[i + 2]};
}

/// Positions moved and scaled into the unit sphere, so that nothing later overflows.
std::vector<Vec3> normalized_positions(const std::vector<float>& values, std::string_view path) {
  constexpr float kWidest = 1e15f;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t i = 0; i < values.size(); i += 3) {
    low = {std::min(low.x, values[i]), std::min(low.y, values[i + 1]),
           std::min(low.z, values[i + 2])};
    high = {std::max(high.x, values[i]), std::max(high.y, values[i + 1]),
            std::max(high.z, values[i + 2])};
  }
  const Vec3 size = high - low;
  const float widest = std::max({size.x, size.y, size.z});
  if (!(widest <= kWidest))
    throw InputError(path, "reaches over {:.2g} units; scale it to 1e15 or less", widest);
  if (!(widest > 0.0f)) throw InputError(path, "has all its vertices in one point");
  const Vec3 centre = low + size * 0.5f;
  std::vector<Vec3> positions;
  float radius2 = 0.0f;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const Vec3 p = (Vec3{values[i], values[i + 1], values[i + 2]} - centre) * (1.0f / widest);
    radius2 = std::max(radius2, dot(p, p));
    positions.push_back(p);
  }
  for (Vec3& p : positions) p = p * (1.0f / std::sqrt(radius2));
  return positions;
}

/// The normal of every vertex: the average over its faces, weighted by area; zero if all of them
/// are degenerate.
std::vector<Vec3> averaged_normals(const std::vector<IndexedTriangle>& triangles,
                                   const std::vector<Vec3>& positions, std::string_view path) {
  std::vector<Vec3> normals(positions.size());
  bool any_area = false;
  for (const IndexedTriangle& t : triangles) {
    const auto at = [&](std::size_t k) { return static_cast<std::size_t>(t[k].vertex_index); };
    const Vec3 a = positions[at(0)];
    const Vec3 twice_area = cross(positions[at(1)] - a, positions[at(2)] - a);
    any_area = any_area || dot(twice_area, twice_area) > 0.0f;
    for (std::size_t k = 0; k < 3; ++k) normals[at(k)] = normals[at(k)] + twice_area;
  }
  if (!any_area) throw InputError(path, "has {} faces, all of zero area", triangles.size());
  return normals;
}

Vec3 unit_or(Vec3 v, Vec3 otherwise) {
  const float size = length(v);
  return size > 1e-20f && std::isfinite(size) ? v * (1.0f / size) : otherwise;
}

/// The loader takes comments only at the beginning of a line.
std::string without_comments(std::string text) {
  bool comment = false;
  for (char& c : text) {
    comment = c != '\n' && (comment || c == '#');
    if (comment) c = ' ';
  }
  return text;
}

std::string read_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(path, "is a folder; use a Wavefront OBJ file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "cannot be opened: {}", std::strerror(errno));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw InputError(path, "cannot be read: {}", std::strerror(errno));
  return text;
}

}  // namespace

TriangleMesh parse_obj(const std::string& text, std::string_view path) {
  check_obj(text, path);
  tinyobj::ObjReaderConfig configuration;
  configuration.triangulate = false;
  configuration.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(without_comments(text), "", configuration))
    throw InputError(path, "cannot be read as a Wavefront OBJ file: {}", reader.Error());

  const std::vector<IndexedTriangle> triangles = fans(reader.GetShapes());
  const std::vector<Vec3> positions = normalized_positions(reader.GetAttrib().vertices, path);
  const std::vector<Vec3> averages = averaged_normals(triangles, positions, path);
  TriangleMesh mesh;
  for (const IndexedTriangle& t : triangles) {
    auto& corners = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(t[k].vertex_index);
      const Vec3 average = unit_or(averages[vertex], {0.0f, 1.0f, 0.0f});
      const int given = t[k].normal_index;
      corners[k].position = positions[vertex];
      corners[k].normal =
          given < 0 ? average : unit_or(vector_at(reader.GetAttrib().normals, given), average);
    }
  }
  return mesh;
}

Scene load_mesh_scene(const std::string& path, MeshPatches patches) {
  if (!path.ends_with(".obj") && !path.ends_with(".OBJ"))
    throw InputError(path, "is not a mesh file that can be read; use a Wavefront OBJ file (.obj)");
  Scene scene;
  scene.add(make_mesh_surface(parse_obj(read_file(path), path), patches));
  scene.camera.eye = {1.35f, 1.0f, 2.85f};
  scene.camera.target = {};
  scene.camera.field_degrees = 36.0f;
  scene.camera.near = 0.2f;
  scene.lighting.to_sun = normalized({-0.4f, 0.75f, 0.55f});
  scene.lighting.background = {0.16f, 0.18f, 0.21f};
  return scene;
}

}  // namespace lanescope
