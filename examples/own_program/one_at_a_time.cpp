// SPDX-License-Identifier: MIT
#include "one_at_a_time.h"

#include "kernels/kernel.h"
#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/options.h"
#include "starters.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {

extern const Kernel k_one_at_a_time;
const Kernel k_one_at_a_time{
    .name = "one_at_a_time",
    .summary = "one micropolygon at a time, a lane for each candidate sample of its box",
    .workload = &w_micropolygons,
    .parameters = joined(raster_parameters(), sampling_parameters()),
    .stages = kOneAtATimeStages,
    .counters = std::span(kRasterizerCounters).first<kConflictHits + 1>(),
    .sums = kRasterizerSums,
    .metrics = std::span(kRasterizerMetrics).first<3>(),
    .output_counters = kFrameCounters,
    .element = kMicropolygon,
    .instructions = kRasterizerInstructions,
    .most_width = most_width_of_one_at_a_time(),
    .open = open_frame,
    .output_bytes = frame_bytes,
    .start = start_one_at_a_time,
};

}  // namespace lanescope
