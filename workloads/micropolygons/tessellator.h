// SPDX-License-Identifier: MIT
// REYES (Cook, Carpenter and Catmull 1987): bound, cull, split, dice, project, shade, and emit
// micropolygons grid by grid.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "workloads/geometry/camera.h"
#include "workloads/micropolygons/grid.h"
#include "workloads/micropolygons/micropolygon.h"
#include "workloads/micropolygons/patch.h"
#include "workloads/micropolygons/scene.h"

namespace lanescope {

struct TessellationOptions {
  int width_px = 1728;
  int height_px = 1080;
  /// Sub-pixel cells along each side of a pixel, as in the SampleGrid that the packets are for:
  /// vertices come out in cells.
  int samples_per_axis = 2;
  Micropolygon shape = Micropolygon::kTriangle;
  /// Target area of a quad of the grid in pixels; a triangle has half of it.
  float dice_area_px = 1.0f;
  /// A grid has at most grid_limit x grid_limit quads.
  int grid_limit = 16;
  /// Micropolygons in a packet; kernels drain at its end (the `--drain` option).
  int packet_capacity = 2880;
  /// How far the outer vertices of each grid are moved outward, so that neighbouring grids of
  /// different rates leave no cracks.
  float grid_overlap_px = kGridOverlapPx;
};

/// What the tessellator did; sums over segments.
struct TessellationCounts {
  std::uint64_t patches_culled = 0;  ///< Patches dropped because they are outside the view.
  std::uint64_t patches_split = 0;
  std::uint64_t patches_dropped =
      0;  ///< At the depth limit partly behind the camera or not finite.
  std::uint64_t grids = 0;
  std::uint64_t micropolygons = 0;  ///< Emitted.
  std::uint64_t dropped = 0;        ///< Not emitted: behind the camera or not finite.

  TessellationCounts& operator+=(const TessellationCounts& other);
};

/// Turns a scene into packets. A scene is divided into segments, which are independent of one
/// another: each ends with a packet of its own, so that any number of threads can take segments in
/// any order and the packets are the same. Memory is constant in the number of micropolygons.
class Tessellator {
 public:
  using PacketSink = std::function<void(const Packet&)>;

  /// Keeps a reference to `scene`. Throws InputError for options out of range.
  Tessellator(const Scene& scene, const TessellationOptions& options);

  int segment_count() const { return static_cast<int>(segment_starts_.size()) - 1; }

  /// Tessellates one segment and hands each packet, full or the segment's last, to `sink`; the
  /// packet is reused after the call. Thread-safe. Micropolygon ids are segment << 32 | index.
  TessellationCounts tessellate(int segment, const PacketSink& sink) const;

 private:
  void divide_into_segments();

  const Scene& scene_;
  TessellationOptions options_;
  Projection projection_;
  std::vector<Patch> patches_;               ///< Of all segments, in order.
  std::vector<std::size_t> segment_starts_;  ///< Segment s is patches [starts[s], starts[s + 1]).
};

}  // namespace lanescope
