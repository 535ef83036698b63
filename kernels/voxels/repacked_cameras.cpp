// SPDX-License-Identifier: MIT
#include "kernels/voxels/repacked_cameras.h"

#include "kernels/kernel.h"
#include "kernels/voxels/counters.h"
#include "kernels/voxels/options.h"
#include "kernels/voxels/starters.h"
#include "kernels/widths.h"
#include "workloads/voxels/workload.h"

namespace lanescope {

extern const Kernel k_repacked_cameras;
const Kernel k_repacked_cameras{
    .name = "repacked_cameras",
    .summary = "lanes are octants of corners, each at its next filled cube (REPACK's idea)",
    .workload = &w_voxels,
    .parameters = joined(merge_parameters()),
    .stages = kProbeStages,
    .counters = kProbeCounters,
    .sums = kProbeSums,
    .metrics = kProbeMetrics,
    .element = kProbeElement,
    .most_width = kMostLanes,
    .open = open_probe_field,
    .output_bytes = probe_field_bytes,
    .start = start_repacked_cameras,
};

}  // namespace lanescope
