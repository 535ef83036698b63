// SPDX-License-Identifier: MIT
#include "kernels/voxels/across_image.h"

#include "kernels/kernel.h"
#include "kernels/voxels/counters.h"
#include "kernels/voxels/options.h"
#include "kernels/voxels/or_into.h"
#include "kernels/voxels/starters.h"
#include "kernels/widths.h"
#include "workloads/voxels/workload.h"

namespace lanescope {

extern const Kernel k_across_image;
const Kernel k_across_image{
    .name = "across_image",
    .summary = "the article's form: a lane is a word of the image",
    .workload = &w_voxels,
    .parameters = joined(packing_parameters()),
    .stages = kProbeStages,
    .counters = kProbeCounters,
    .sums = kProbeSums,
    .metrics = kProbeMetrics,
    .element = kProbeElement,
    .instructions = kProbeInstructions,
    .most_width = kMostLanes,
    .open = open_probe_field,
    .output_bytes = probe_field_bytes,
    .start = start_across_image,
};

}  // namespace lanescope
