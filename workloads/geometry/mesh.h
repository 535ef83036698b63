// SPDX-License-Identifier: MIT
// Meshes of triangles: made from the polygons of a file, and turned into patches.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/choice.h"
#include "workloads/geometry/polygon_mesh.h"
#include "workloads/geometry/surface.h"
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

struct MeshCorner {
  Vec3 position;
  Vec3 normal;  ///< Unit vector.
};

/// Counterclockwise as seen from outside.
using MeshTriangle = std::array<MeshCorner, 3>;

struct TriangleMesh {
  std::vector<MeshTriangle> triangles;
  /// What of the file was skipped or replaced: sentences that begin with the file.
  std::vector<std::string> notes;
};

/// Called with the finished share of reading, from 0 to 1; may be empty.
using MeshProgress = std::function<void(double)>;

/// Cuts polygons into triangles. The vertices that faces use are moved and scaled into the unit
/// sphere about the origin, before they are rounded. Corners without a normal get the average over
/// the faces around their vertex, weighted by area. Throws InputError, whose text starts with
/// `path`, if all vertices are in one point, if no face has an area, and for too many triangles.
TriangleMesh triangle_mesh(PolygonMesh polygons, std::string_view path);

/// Reads the text of an OBJ file. Throws InputError as read_obj and triangle_mesh do.
TriangleMesh parse_obj(std::string_view text, std::string_view path,
                       const MeshProgress& progress = {});

/// Reads an OBJ file. Throws InputError as parse_obj does, and for files that cannot be read.
TriangleMesh load_mesh(const std::string& path, const MeshProgress& progress = {});

/// A surface of three patches for each triangle, which meet in its middle. Neighbours meet along
/// their edge, also where they have different normals there.
std::unique_ptr<Surface> make_mesh_surface(TriangleMesh mesh, MeshPatches patches);

}  // namespace lanescope
