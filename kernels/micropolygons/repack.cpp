// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/repack.h"

#include "kernels/kernel.h"
#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/options.h"
#include "kernels/micropolygons/starters.h"
#include "kernels/widths.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {

extern const Kernel k_repack;
const Kernel k_repack{
    .name = "repack",
    .summary = "work is compacted between stages to keep every lane busy (the thesis, 3.2.2)",
    .workload = &w_micropolygons,
    .parameters = joined(raster_parameters(), repack_parameters(), sampling_parameters()),
    .stages = kRepackStages,
    .counters = kRasterizerCounters,
    .sums = kRasterizerSums,
    .metrics = kRasterizerMetrics,
    .series = kWorkingSetSeries,
    .output_counters = kFrameCounters,
    .element = kMicropolygon,
    .instructions = kRasterizerInstructions,
    .most_width = kMostLanes,
    .open = open_frame,
    .output_bytes = frame_bytes,
    .start = start_repack,
};

}  // namespace lanescope
