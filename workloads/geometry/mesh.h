// SPDX-License-Identifier: MIT
// Meshes of triangles: read from Wavefront OBJ files, turned into patches, framed by a camera.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/choice.h"
#include "workloads/geometry/scene.h"
#include "workloads/geometry/vector.h"

namespace lanescope {

/// How a triangle becomes a patch.
enum class MeshPatches {
  kLinear,  ///< Flat.
  kPn,      ///< A cubic that follows the normals at the corners (Vlachos et al. 2001).
  kPhong,   ///< A quadratic that does (Boubekeur and Alexa 2008).
};

inline constexpr std::array<Choice<MeshPatches>, 3> kMeshPatches{
    {{"linear", MeshPatches::kLinear}, {"pn", MeshPatches::kPn}, {"phong", MeshPatches::kPhong}}};

struct TriangleMesh {
  struct Corner {
    Vec3 position;
    Vec3 normal;  ///< Unit vector.
  };
  /// Counterclockwise as seen from outside.
  std::vector<std::array<Corner, 3>> triangles;
};

/// Reads the faces of an OBJ file's text; polygons are cut into fans. Normals that the file does
/// not give are averages over the faces around a vertex, weighted by area. The mesh is moved and
/// scaled into the unit sphere about the origin. Throws InputError, whose text starts with `path`
/// and, where there is one, the line.
TriangleMesh parse_obj(const std::string& text, std::string_view path);

/// A surface of three patches for each triangle, which meet in its middle.
std::unique_ptr<Surface> make_mesh_surface(TriangleMesh mesh, MeshPatches patches);

/// Reads an OBJ file as a scene, with a camera that frames it. Throws InputError as parse_obj does,
/// and for files that cannot be read.
Scene load_mesh_scene(const std::string& path, MeshPatches patches);

}  // namespace lanescope
