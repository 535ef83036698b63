// SPDX-License-Identifier: MIT
#include "kernels/voxels/across_cubes.h"

#include "kernels/kernel.h"
#include "kernels/voxels/counters.h"
#include "kernels/voxels/starters.h"
#include "kernels/widths.h"
#include "workloads/voxels/workload.h"

namespace lanescope {

extern const Kernel k_across_cubes;
const Kernel k_across_cubes{
    .name = "across_cubes",
    .summary = "a lane is a filled cube; images are merged by reduction",
    .workload = &w_voxels,
    .stages = kProbeStages,
    .counters = kProbeCounters,
    .sums = kProbeSums,
    .metrics = kProbeMetrics,
    .element = kProbeElement,
    .most_width = kMostLanes,
    .open = open_probe_field,
    .output_bytes = probe_field_bytes,
    .start = start_across_cubes,
};

}  // namespace lanescope
