// SPDX-License-Identifier: MIT
// Patches of triangles. A triangle is cut into three quadrilaterals, each from a corner over the
// middles of the two edges there to the middle of the triangle: no patch comes to a point.
#include <optional>

#include "workloads/geometry/creases.h"
#include "workloads/geometry/mesh.h"

namespace lanescope {
namespace {

/// Weights of the three corners.
using Barycentric = std::array<float, 3>;

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

Vec3 linear_point(const MeshTriangle& t, const Barycentric& w) {
  return t[0].position * w[0] + t[1].position * w[1] + t[2].position * w[2];
}

Vec3 linear_normal(const MeshTriangle& t, const Barycentric& w) {
  return t[0].normal * w[0] + t[1].normal * w[1] + t[2].normal * w[2];
}

/// How far the point of a patch lies from that of the flat triangle, against its normals. A cubic
/// through the corners whose control points on the edges are thirds of them, moved onto the tangent
/// planes of the nearer corners; the one in the middle goes half as far beyond the average of these
/// as it lies from that of the corners.
Vec3 pn_offset(const EdgeOffsets& offsets, const Barycentric& w) {
  Vec3 sum, all;
  for (std::size_t e = 0; e < 3; ++e) {
    const float here = w[e], there = w[(e + 1) % 3];
    sum = sum + (offsets[2 * e] * here + offsets[2 * e + 1] * there) * (here * there);
    all = all + offsets[2 * e] + offsets[2 * e + 1];
  }
  return sum + all * (0.5f * w[0] * w[1] * w[2]);
}

/// The same for the points of the triangle, moved onto the tangent planes of all corners.
Vec3 phong_offset(const EdgeOffsets& offsets, const Barycentric& w) {
  constexpr float kShare = 0.75f;  // The authors' value.
  Vec3 sum;
  for (std::size_t e = 0; e < 3; ++e)
    sum = sum + (offsets[2 * e] + offsets[2 * e + 1]) * (w[e] * w[(e + 1) % 3]);
  return sum * kShare;
}

using OffsetFunction = Vec3 (*)(const EdgeOffsets&, const Barycentric&);

class MeshSurface final : public Surface {
 public:
  /// Flat triangles if there is no function.
  MeshSurface(TriangleMesh mesh, OffsetFunction offset)
      : triangles_(std::move(mesh.triangles)), offset_(offset) {
    if (offset_) creases_.emplace(triangles_);
  }

  int patch_count() const override { return 3 * static_cast<int>(triangles_.size()); }

  void evaluate(int patch, const ParameterGrid& grid, SurfacePoint* points) const override {
    const EdgeOffsets offsets = offset_ ? offsets_of(patch / 3) : EdgeOffsets{};
    for_each(patch, grid, [&](const MeshTriangle& t, const Barycentric& w) {
      Vec3 p = linear_point(t, w);
      if (offset_) p = p - offset_(offsets, w);
      points->position = points->pattern = p;
      ++points;
    });
  }

  bool evaluate_normals(int patch, const ParameterGrid& grid, Vec3* normals) const override {
    for_each(patch, grid, [&](const MeshTriangle& t, const Barycentric& w) {
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
    const MeshTriangle& triangle = triangles_[static_cast<std::size_t>(patch / 3)];
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        visit(triangle, weights(patch % 3, grid.u(column), grid.v(row)));
  }

  EdgeOffsets offsets_of(int triangle) const {
    const auto t = static_cast<std::size_t>(triangle);
    const EdgeOffsets* const shared = creases_->find(t);
    return shared ? *shared : edge_offsets(triangles_[t]);
  }

  std::vector<MeshTriangle> triangles_;
  OffsetFunction offset_;
  std::optional<Creases> creases_;
};

OffsetFunction offset_function(MeshPatches patches) {
  switch (patches) {
    case MeshPatches::kLinear:
      return nullptr;
    case MeshPatches::kPn:
      return pn_offset;
    case MeshPatches::kPhong:
      return phong_offset;
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<Surface> make_mesh_surface(TriangleMesh mesh, MeshPatches patches) {
  return std::make_unique<MeshSurface>(std::move(mesh), offset_function(patches));
}

}  // namespace lanescope
