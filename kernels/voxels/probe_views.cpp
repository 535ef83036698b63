// SPDX-License-Identifier: MIT
#include "kernels/voxels/probe_views.h"

#include <algorithm>

#include "kernels/voxels/cubemaps.h"
#include "kernels/voxels/probe_field.h"
#include "kernels/voxels/starters.h"
#include "kernels/voxels/world_picture.h"
#include "kernels/widths.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

/// A world in another light.
class WorldView final : public ProbeField {
 public:
  WorldView(const VoxelSource& source, Shown shown)
      : ProbeField(source.world(), source.probe_count()), shown_(shown) {}
  std::optional<Raster> picture() const override { return draw_world(world(), *this, shown_); }

 private:
  Shown shown_;
};

template <Shown kShown>
std::unique_ptr<Output> open_world(const Arguments&, const Source& source) {
  return std::make_unique<WorldView>(static_cast<const VoxelSource&>(source), kShown);
}

/// The fastest program renders the probes.
std::unique_ptr<Execution> start_probes(const Launch& launch) {
  return start_across_cameras({kMostLanes, Mode::kUncounted, launch.arguments, launch.output});
}

}  // namespace

const std::array<View, 5> kProbeViews{{
    {"cubes", "the cubes in their colours, without light", open_world<Shown::kCubes>,
     probe_field_bytes, start_probes},
    {"occlusion", "how much of the sky each point sees", open_world<Shown::kOcclusion>,
     probe_field_bytes, start_probes},
    {"ambient", "the light of the sky, by normals", open_world<Shown::kAmbient>, probe_field_bytes,
     start_probes},
    {"lighting", "the light of sky and sun", open_world<Shown::kLighting>, probe_field_bytes,
     start_probes},
    {"cubemaps", "one-bit cubemaps of some probes, enlarged", open_cubemaps, cubemaps_bytes,
     start_cubemaps},
}};

}  // namespace lanescope
