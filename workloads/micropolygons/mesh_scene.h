// SPDX-License-Identifier: MIT
// A mesh as a scene.
#pragma once

#include <string>

#include "workloads/geometry/mesh.h"
#include "workloads/geometry/scene.h"

namespace lanescope {

/// Reads an OBJ file as a scene, with a camera that frames it. The scene's notes say what of the
/// file was skipped, and whether its faces turn their backs to the camera. Throws InputError as
/// load_mesh does.
Scene load_mesh_scene(const std::string& path, MeshPatches patches,
                      const MeshProgress& progress = {});

}  // namespace lanescope
