// SPDX-License-Identifier: MIT
// Reads Wavefront OBJ files.
#pragma once

#include <functional>
#include <string_view>

#include "workloads/geometry/polygon_mesh.h"

namespace lanescope {

/// Reads the polygons of an OBJ file's text in one pass. What exporters write beside them is
/// skipped, and what a picture can do without is replaced: one note counts each.
///   skipped: faces of fewer than three different corners, points, lines, free-form curves and
///     surfaces, statements that are not known
///   replaced: normals with index 0, normals that the file does not hold, zero or not finite ones:
///     those corners have none
/// Groups, materials, texture coordinates and whatever follows x, y and z are left out.
/// `progress` is called with the finished share, from 0 to 1; it may be empty.
/// Throws InputError at `path` or `path:line` for what is no text in UTF-8, for coordinates that
/// are not finite numbers, for vertices that the file does not hold, for faces of more than 100,000
/// corners, and for a file without faces.
PolygonMesh read_obj(std::string_view text, std::string_view path,
                     const std::function<void(double)>& progress = {});

}  // namespace lanescope
