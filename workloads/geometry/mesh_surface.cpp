// SPDX-License-Identifier: MIT
// Patches of triangles. A triangle is cut into three quadrilaterals, each from a corner over the
// middles of the two edges there to the middle of the triangle: no patch comes to a point.
#include "workloads/geometry/mesh.h"

namespace lanescope {
namespace {

/// Weights of the three corners.
using Barycentric = std::array<float, 3>;
using Triangle = std::array<TriangleMesh::Corner, 3>;

Barycentric weights(int corner, float u, float v) {
  // Bilinear between the corner, the middle of the edge to the next corner, the middle of the
  // triangle and the middle of the edge to the corner after that.
  const auto here = static_cast<std::size_t>(corner);
  const std::size_t next = (here + 1) % 3, last = (here + 2) % 3;
  Barycentric w{};
  const float along_u = u * (1.0f - v), along_v = v * (1.0f - u), middle = u * v;
  w[next] = 0.5f * along_u + middle / 3.0f;
  w[last] = 0.5f * along_v + middle / 3.0f;
  w[here] = 1.0f - w[next] - w[last];
  return w;
}

Vec3 linear_point(const Triangle& t, const Barycentric& w) {
  return t[0].position * w[0] + t[1].position * w[1] + t[2].position * w[2];
}

Vec3 linear_normal(const Triangle& t, const Barycentric& w) {
  return t[0].normal * w[0] + t[1].normal * w[1] + t[2].normal * w[2];
}

/// `p` moved onto the tangent plane at a corner.
Vec3 onto_plane(const TriangleMesh::Corner& corner, Vec3 p) {
  return p - corner.normal * dot(p - corner.position, corner.normal);
}

Vec3 phong_point(const Triangle& t, const Barycentric& w) {
  constexpr float kShare = 0.75f;  // The authors' value.
  const Vec3 p = linear_point(t, w);
  const Vec3 curved =
      onto_plane(t[0], p) * w[0] + onto_plane(t[1], p) * w[1] + onto_plane(t[2], p) * w[2];
  return mix(p, curved, kShare);
}

Vec3 pn_point(const Triangle& t, const Barycentric& w) {
  // The control point a third of the way from corner i to corner j.
  const auto edge = [&t](std::size_t i, std::size_t j) {
    const Vec3 third = t[i].position * (2.0f / 3.0f) + t[j].position * (1.0f / 3.0f);
    return onto_plane(t[i], third);
  };
  Vec3 sum, edges, corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vec3 from_i = edge(i, j), from_j = edge(j, i);
    sum = sum + t[i].position * (w[i] * w[i] * w[i]) + from_i * (3.0f * w[i] * w[i] * w[j]) +
          from_j * (3.0f * w[i] * w[j] * w[j]);
    edges = edges + from_i + from_j;
    corners = corners + t[i].position;
  }
  const Vec3 middle = edges * (1.0f / 4.0f) - corners * (1.0f / 6.0f);
  return sum + middle * (6.0f * w[0] * w[1] * w[2]);
}

using PointFunction = Vec3 (*)(const Triangle&, const Barycentric&);

class MeshSurface final : public Surface {
 public:
  MeshSurface(TriangleMesh mesh, PointFunction point) : mesh_(std::move(mesh)), point_(point) {}

  int patch_count() const override { return 3 * static_cast<int>(mesh_.triangles.size()); }

  void evaluate(int patch, const ParameterGrid& grid, SurfacePoint* points) const override {
    for_each(patch, grid, [&](const Triangle& t, const Barycentric& w) {
      points->position = points->pattern = point_(t, w);
      ++points;
    });
  }

  bool evaluate_normals(int patch, const ParameterGrid& grid, Vec3* normals) const override {
    for_each(patch, grid, [&](const Triangle& t, const Barycentric& w) {
      const Vec3 n = linear_normal(t, w);
      const float size = length(n);
      *normals++ = size > 1e-6f ? n * (1.0f / size) : t[0].normal;
    });
    return true;
  }

  void materials(const SurfacePoint* /*points*/, const Vec3* /*normals*/, int count,
                 Material* materials) const override {
    for (int i = 0; i < count; ++i)
      materials[i] = {.albedo = {0.62f, 0.55f, 0.46f}, .gloss = 0.25f, .sharpness = 5};
  }

 private:
  template <class Visit>
  void for_each(int patch, const ParameterGrid& grid, Visit visit) const {
    const Triangle& triangle = mesh_.triangles[static_cast<std::size_t>(patch / 3)];
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        visit(triangle, weights(patch % 3, grid.u(column), grid.v(row)));
  }

  TriangleMesh mesh_;
  PointFunction point_;
};

PointFunction point_function(MeshPatches patches) {
  switch (patches) {
    case MeshPatches::kLinear:
      return linear_point;
    case MeshPatches::kPn:
      return pn_point;
    case MeshPatches::kPhong:
      return phong_point;
  }
  return linear_point;
}

}  // namespace

std::unique_ptr<Surface> make_mesh_surface(TriangleMesh mesh, MeshPatches patches) {
  return std::make_unique<MeshSurface>(std::move(mesh), point_function(patches));
}

}  // namespace lanescope
