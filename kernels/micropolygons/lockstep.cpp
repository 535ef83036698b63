// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/lockstep.h"

#include "kernels/kernel.h"
#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/options.h"
#include "kernels/micropolygons/starters.h"
#include "kernels/widths.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {

extern const Kernel k_lockstep;
const Kernel k_lockstep{
    .name = "lockstep",
    .summary = "W micropolygons in lockstep, one in each lane (the thesis, 3.2.1)",
    .workload = &w_micropolygons,
    .parameters = joined(raster_parameters(), sampling_parameters()),
    .stages = kLockstepStages,
    .counters = std::span(kRasterizerCounters).first<kConflictHits + 1>(),
    .sums = kRasterizerSums,
    .metrics = std::span(kRasterizerMetrics).first<3>(),
    .output_counters = kFrameCounters,
    .element = kMicropolygon,
    .instructions = kRasterizerInstructions,
    .most_width = kMostLanes,
    .open = open_frame,
    .output_bytes = frame_bytes,
    .start = start_lockstep,
};

}  // namespace lanescope
