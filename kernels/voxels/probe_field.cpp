// SPDX-License-Identifier: MIT
#include "kernels/voxels/probe_field.h"

#include <bit>

#include "kernels/voxels/world_picture.h"
#include "simulator/base/random.h"
#include "workloads/voxels/options.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

/// At most one corner in so many of a cube of the world's length is a probe: caves have the most,
/// one in four of 24 x 24 x 24, one in eight of larger worlds.
constexpr std::uint64_t kCornersPerProbe = 4;
constexpr int kSizeOfUnknown = 256;

}  // namespace

std::uint64_t ProbeField::hash() const {
  std::uint64_t hash = mix64(probes_.size());
  for (const Harmonics& harmonics : probes_)
    for (const float value : harmonics) hash = mix64(hash ^ std::bit_cast<std::uint32_t>(value));
  return hash;
}

std::optional<Raster> ProbeField::picture() const {
  return draw_world(*world_, *this, Shown::kFinal);
}

bool ProbeField::reopen(const Arguments& /*arguments*/, const Source& source) {
  const auto& voxels = static_cast<const VoxelSource&>(source);
  world_ = voxels.world();
  probes_.assign(voxels.probe_count(), {});
  return true;
}

std::unique_ptr<Output> open_probe_field(const Arguments& /*arguments*/, const Source& source) {
  const auto& voxels = static_cast<const VoxelSource&>(source);
  return std::make_unique<ProbeField>(voxels.world(), voxels.probe_count());
}

std::uint64_t probe_field_bytes(const Arguments& arguments) {
  const auto size = static_cast<std::uint64_t>(
      decoded(world_parameters(), arguments).size_cubes.value_or(kSizeOfUnknown));
  return size * size * size / kCornersPerProbe * sizeof(Harmonics);
}

}  // namespace lanescope
