// SPDX-License-Identifier: MIT
// Cuts polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "workloads/geometry/polygon_mesh.h"

namespace lanescope {

/// Indices into the polygon, in its orientation.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Cuts a polygon of n corners into n - 2 triangles, which replace `triangles`. It is a fan from
/// the first corner where that covers the polygon and nothing else, as with every convex one; else
/// ears are clipped in the plane that fits the polygon best. A polygon that crosses itself or has
/// no area gets some triangles of its corners. Requires n >= 3.
void triangulate(std::span<const Point3> polygon, std::vector<PolygonTriangle>& triangles);

}  // namespace lanescope
