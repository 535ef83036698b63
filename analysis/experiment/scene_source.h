// SPDX-License-Identifier: MIT
// The scene that a configuration names.
#pragma once

#include "analysis/configuration/configuration.h"
#include "workloads/micropolygons/scene.h"

namespace lanescope {

/// Builds the built-in scene or loads the mesh, with the picture turned as asked. Throws InputError
/// if there is no such scene or the mesh cannot be loaded.
Scene build_scene(const Configuration& configuration);

/// Whether the configuration's scene is one of those that the thesis's tables average.
bool is_thesis_like(const Configuration& configuration);

}  // namespace lanescope
