// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/descriptors.h"

#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/lockstep.h"
#include "kernels/micropolygons/options.h"
#include "kernels/micropolygons/repack.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {

namespace {

/// What both have alike.
Kernel vector_rasterizer(std::string_view name, std::string_view summary, int most_width,
                         StartExecution start) {
  return {
      .name = name,
      .summary = summary,
      .workload = &w_micropolygons,
      .sums = kRasterizerSums,
      .output_counters = kFrameCounters,
      .element = kMicropolygon,
      .instructions = kRasterizerInstructions,
      .most_width = most_width,
      .open = open_frame,
      .output_bytes = frame_bytes,
      .start = start,
  };
}

}  // namespace

Kernel lockstep_kernel(std::string_view name, std::string_view summary, int most_width,
                       StartExecution start) {
  Kernel kernel = vector_rasterizer(name, summary, most_width, start);
  kernel.parameters = joined(raster_parameters(), sampling_parameters());
  kernel.stages = kLockstepStages;
  kernel.counters = std::span(kRasterizerCounters).first<kConflictHits + 1>();
  kernel.metrics = std::span(kRasterizerMetrics).first<3>();
  return kernel;
}

Kernel repack_kernel(std::string_view name, std::string_view summary, int most_width,
                     StartExecution start) {
  Kernel kernel = vector_rasterizer(name, summary, most_width, start);
  kernel.parameters = joined(raster_parameters(), repack_parameters(), sampling_parameters());
  kernel.stages = kRepackStages;
  kernel.counters = kRasterizerCounters;
  kernel.metrics = kRasterizerMetrics;
  kernel.series = kWorkingSetSeries;
  return kernel;
}

}  // namespace lanescope
