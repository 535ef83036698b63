// SPDX-License-Identifier: MIT
// What tests of the workloads share: tessellating a whole scene into a list.
#pragma once

#include <vector>

#include "workloads/micropolygons/tessellator.h"

namespace lanescope::test {

/// A micropolygon as a test looks at it.
struct Polygon {
  int corners = 3;
  Vertex vertex[4];

  float x(int i) const { return vertex[i][Attribute::kX]; }
  float y(int i) const { return vertex[i][Attribute::kY]; }
  /// Positive for front faces, in square cells.
  double area() const {
    double twice = 0.0;
    for (int i = 0; i < corners; ++i) {
      const int j = (i + 1) % corners;
      twice += double{x(i)} * y(j) - double{x(j)} * y(i);
    }
    return 0.5 * twice;
  }
};

inline Polygon polygon_of(const Packet& packet, int index) {
  Polygon polygon;
  polygon.corners = corner_count(packet.shape());
  for (int corner = 0; corner < polygon.corners; ++corner)
    for (int a = 0; a < kAttributeCount; ++a) {
      const auto attribute = static_cast<Attribute>(a);
      polygon.vertex[corner][attribute] = packet.values(corner, attribute)[index];
    }
  return polygon;
}

struct Tessellation {
  std::vector<Polygon> polygons;
  TessellationCounts counts;
};

inline void add(TessellationCounts& sum, const TessellationCounts& counts) {
  sum.patches_culled += counts.patches_culled;
  sum.patches_split += counts.patches_split;
  sum.patches_dropped += counts.patches_dropped;
  sum.grids += counts.grids;
  sum.micropolygons += counts.micropolygons;
  sum.dropped += counts.dropped;
}

inline Tessellation tessellate(const Scene& scene, const TessellationOptions& options) {
  Tessellation result;
  const Tessellator tessellator(scene, options);
  for (int segment = 0; segment < tessellator.segment_count(); ++segment)
    add(result.counts, tessellator.tessellate(segment, [&](const Packet& packet) {
      for (int i = 0; i < packet.size(); ++i) result.polygons.push_back(polygon_of(packet, i));
    }));
  return result;
}

/// A small frame, on which a scene has about 300,000 triangles.
inline TessellationOptions small_options(Micropolygon shape) {
  TessellationOptions options;
  options.width_px = 288;
  options.height_px = 180;
  options.shape = shape;
  return options;
}

/// A surface that is a function.
template <class Function>
struct FunctionShape {
  Function function;
  static int patch_count() { return 1; }
  SurfacePoint point(int /*patch*/, float u, float v) const {
    SurfacePoint p;
    p.position = function(u, v);
    return p;
  }
  static Material material(const SurfacePoint& /*point*/, Vec3 /*normal*/) { return {}; }
};

}  // namespace lanescope::test
