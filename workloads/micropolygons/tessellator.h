// SPDX-License-Identifier: MIT
// REYES (Cook, Carpenter and Catmull 1987): bound, cull, split, dice, project, shade, and emit
// micropolygons grid by grid.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "workloads/geometry/camera.h"
#include "workloads/geometry/scene.h"
#include "workloads/micropolygons/grid.h"
#include "workloads/micropolygons/micropolygon.h"
#include "workloads/micropolygons/options.h"
#include "workloads/micropolygons/patch.h"

namespace lanescope {

/// What the tessellator did; sums over segments.
struct TessellationCounts {
  std::uint64_t patches_culled = 0;
  std::uint64_t patches_split = 0;
  std::uint64_t patches_dropped = 0;
  std::uint64_t grids = 0;
  std::uint64_t micropolygons = 0;
  std::uint64_t dropped = 0;

  /// In the order of kTessellationCounters.
  std::vector<std::uint64_t> values() const {
    return {patches_culled, patches_split, patches_dropped, grids, micropolygons, dropped};
  }
};

inline constexpr std::array<CounterInfo, 6> kTessellationCounters{{
    {"patches_culled", "patches dropped because they are outside the view", "patches"},
    {"patches_split", "patches cut in two", "patches"},
    {"patches_dropped", "patches at the depth limit, partly behind the camera or not finite",
     "patches"},
    {"grids", "grids diced", "grids"},
    {"micropolygons", "micropolygons emitted", "micropolygons"},
    {"dropped", "micropolygons not emitted: behind the camera or not finite", "micropolygons"},
}};

/// Turns a scene into packets. A scene is divided into segments, which are independent of one
/// another: each ends with a packet of its own, so that any number of threads can take segments in
/// any order and the packets are the same. Memory is constant in the number of micropolygons.
class Tessellator {
 public:
  using PacketSink = std::function<void(const Packet&)>;

  /// Keeps a reference to `scene`. `progress` hears how its division goes, and may be empty. Throws
  /// InputError for options out of range.
  Tessellator(const Scene& scene, const TessellationOptions& options,
              const OpeningProgress& progress = {});

  int segment_count() const { return static_cast<int>(segment_starts_.size()) - 1; }

  /// Tessellates one segment and hands each packet, full or the segment's last, to `sink`; the
  /// packet is reused after the call. Thread-safe. Micropolygon ids are segment << 32 | index.
  TessellationCounts tessellate(int segment, const PacketSink& sink) const;

 private:
  /// Patches of a surface that are whole and follow each other: a mesh has many.
  struct PatchRun {
    Patch first;
    int count;

    bool goes_on_with(const Patch& patch) const {
      return first.depth == 0 && patch.depth == 0 && first.surface == patch.surface &&
             first.index + count == patch.index;
    }
  };

  void divide_into_segments(const OpeningProgress& progress);
  void append(const Patch& patch);

  const Scene& scene_;
  TessellationOptions options_;
  Projection projection_;
  std::vector<PatchRun> runs_;               ///< Of all segments, in order.
  std::vector<std::size_t> segment_starts_;  ///< Segment s is runs [starts[s], starts[s + 1]).
};

}  // namespace lanescope
