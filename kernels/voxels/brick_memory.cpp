// SPDX-License-Identifier: MIT
#include "kernels/voxels/vector_kernel.h"

namespace lanescope {

BrickMemory::BrickMemory(const Brick& brick) : brick(&brick) {
  row.reserve(brick.probes.size());
  bit.reserve(brick.probes.size());
  for (const Probe& probe : brick.probes) {
    row.push_back(Brick::row(kReach + probe.y, kReach + probe.z));
    bit.push_back(probe.x);
  }
}

const std::vector<std::int32_t>& octant_row_steps() {
  static const std::vector<std::int32_t> steps = [] {
    std::vector<std::int32_t> all;
    for (int octant = 0; octant < kOctants; ++octant)
      for (const OctantRow& row : octant_rows())
        all.push_back((octant & 2 ? -row.y : row.y) * Brick::row(1, 0) +
                      (octant & 4 ? -row.z : row.z) * Brick::row(0, 1));
    return all;
  }();
  return steps;
}

Memory<float> harmonics_of(ProbeField& field, const Brick& brick) {
  return {field.data() + kHarmonics * brick.first_probe, kHarmonics * brick.probes.size(),
          "harmonics of probes", nullptr};
}

}  // namespace lanescope
