// SPDX-License-Identifier: MIT
#include "kernels/voxels/across_cameras.h"

#include "kernels/kernel.h"
#include "kernels/voxels/counters.h"
#include "kernels/voxels/starters.h"
#include "kernels/widths.h"
#include "workloads/voxels/workload.h"

namespace lanescope {

extern const Kernel k_across_cameras;
const Kernel k_across_cameras{
    .name = "across_cameras",
    .summary = "a lane is a corner; all walk the same cubes, masked where theirs is empty",
    .workload = &w_voxels,
    .stages = kProbeStages,
    .counters = kProbeCounters,
    .sums = kProbeSums,
    .metrics = kProbeMetrics,
    .element = kProbeElement,
    .instructions = kProbeInstructions,
    .most_width = kMostLanes,
    .open = open_probe_field,
    .output_bytes = probe_field_bytes,
    .start = start_across_cameras,
};

}  // namespace lanescope
