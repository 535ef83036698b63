// SPDX-License-Identifier: MIT
#include "tests/workloads/geometry/mesh_probe.h"

#include <algorithm>
#include <array>

#include "simulator/base/error.h"
#include "workloads/geometry/facing.h"
#include "workloads/geometry/obj_reader.h"

namespace lanescope::test {
namespace {

/// Patches that are looked at; large meshes would take long.
constexpr int kPatches = 96;

void require(bool condition, const char* promise) {
  if (!condition) throw std::logic_error(promise);
}

void check_polygons(const PolygonMesh& mesh) {
  std::size_t begin = 0;
  for (const std::size_t end : mesh.face_ends) {
    require(begin + 3 <= end && end <= mesh.corners.size(), "a face has three corners or more");
    begin = end;
  }
  require(begin == mesh.corners.size(), "every corner is of a face");
  for (const PolygonMesh::Corner& corner : mesh.corners) {
    require(corner.vertex < mesh.positions.size(), "a corner has a vertex");
    require(corner.normal == PolygonMesh::kNone || corner.normal < mesh.normals.size(),
            "a corner has a normal or none");
  }
}

bool is_unit(Vec3 v) { return std::abs(length(v) - 1.0f) < 1e-3f; }

void check_triangles(const TriangleMesh& mesh) {
  for (const MeshTriangle& triangle : mesh.triangles)
    for (const MeshCorner& corner : triangle) {
      require(length(corner.position) < 1.001f, "positions are in the unit sphere");
      require(is_unit(corner.normal), "normals are unit vectors");
    }
  for (const std::string& note : mesh.notes)
    require(note.starts_with("m.obj: ") && note.find('\n') == note.npos, "a note is a line");
}

void check_patches(const Surface& surface) {
  std::array<SurfacePoint, 9> points;
  std::array<Vec3, 9> normals;
  const ParameterGrid grid{0.0f, 0.0f, 0.5f, 0.5f, 3, 3};
  for (int patch = 0; patch < std::min(kPatches, surface.patch_count()); ++patch) {
    surface.evaluate(patch, grid, points.data());
    surface.evaluate_normals(patch, grid, normals.data());
    for (const SurfacePoint& p : points)
      require(length(p.position) < 10.0f, "patches stay near their triangles");
    for (const Vec3 n : normals) require(is_unit(n), "normals of patches are unit vectors");
  }
}

}  // namespace

bool probe_mesh(std::string_view text) {
  try {
    check_polygons(read_obj(text, "m.obj"));
    const TriangleMesh mesh = parse_obj(text, "m.obj");
    check_triangles(mesh);
    Camera camera;
    camera.eye = {0.0f, 0.0f, 3.0f};
    camera.target = {};
    const double backs = facing_of(mesh, camera).backs_in_view;
    require(backs >= 0.0 && backs <= 1.0, "a share is a share");
    for (const auto& choice : kMeshPatches) check_patches(*make_mesh_surface(mesh, choice.value));
    return true;
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    require(message.starts_with("m.obj:") && message.find('\n') == message.npos,
            "a message is a line that names the file");
    return false;
  }
}

}  // namespace lanescope::test
