// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/descriptors.h"

#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/lockstep.h"
#include "kernels/micropolygons/options.h"
#include "kernels/micropolygons/repack.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {

Kernel lockstep_kernel(std::string_view name, std::string_view summary, int most_width,
                       StartExecution start, std::span<const InstructionInfo* const> instructions) {
  return {
      .name = name,
      .summary = summary,
      .workload = &w_micropolygons,
      .parameters = joined(raster_parameters(), sampling_parameters()),
      .stages = kLockstepStages,
      .counters = std::span(kRasterizerCounters).first<kConflictHits + 1>(),
      .sums = kRasterizerSums,
      .metrics = std::span(kRasterizerMetrics).first<3>(),
      .output_counters = kFrameCounters,
      .element = kMicropolygon,
      .instructions = instructions,
      .most_width = most_width,
      .open = open_frame,
      .output_bytes = frame_bytes,
      .start = start,
  };
}

Kernel repack_kernel(std::string_view name, std::string_view summary, int most_width,
                     StartExecution start, std::span<const InstructionInfo* const> instructions) {
  return {
      .name = name,
      .summary = summary,
      .workload = &w_micropolygons,
      .parameters = joined(raster_parameters(), repack_parameters(), sampling_parameters()),
      .stages = kRepackStages,
      .counters = kRasterizerCounters,
      .sums = kRasterizerSums,
      .metrics = kRasterizerMetrics,
      .series = kWorkingSetSeries,
      .output_counters = kFrameCounters,
      .element = kMicropolygon,
      .instructions = instructions,
      .most_width = most_width,
      .open = open_frame,
      .output_bytes = frame_bytes,
      .start = start,
  };
}

}  // namespace lanescope
