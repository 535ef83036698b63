// SPDX-License-Identifier: MIT
// Who owns a sample that lies exactly on an edge: the one rule for every kernel.
#pragma once

namespace lanescope {

/// The top-left rule, for edges from a to b of a polygon with positive area (clockwise on the
/// screen, y down): a polygon owns its left edges (which go up) and its horizontal top edges (which
/// go right). Of the two directions of an edge exactly one is owned, so of two polygons that share
/// it exactly one covers a sample on it.
constexpr bool owns_edge(float dx, float dy) { return dy < 0.0f || (dy == 0.0f && dx > 0.0f); }

}  // namespace lanescope
