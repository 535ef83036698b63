// SPDX-License-Identifier: MIT
// Reads worlds from MagicaVoxel files (.vox).
#pragma once

#include <string>
#include <string_view>

#include "workloads/voxels/world.h"

namespace lanescope {

/// Reads every model of the file, placed as its scene graph says, or all at one place if there is
/// none; MagicaVoxel's z, which is up, becomes y, and hidden nodes and layers are left out. Throws
/// InputError, which begins with the file and names the byte where there is one, if it cannot be
/// read, is no such file, is cut off, says what cannot be, has no cube, or is larger than a World
/// may be.
World read_vox(const std::string& file);

/// The same of the content of a file; `name` is what messages call it.
World parse_vox(const std::string& name, std::string_view bytes);

}  // namespace lanescope
