// SPDX-License-Identifier: MIT
#include "kernels/kernel.h"
#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/starters.h"
#include "kernels/widths.h"

namespace lanescope {
namespace {

constexpr std::string_view kStages[] = {"Setup", "Bound", "Test Stream-load", "Test", "Process"};

}  // namespace

extern const Kernel k_repack;
const Kernel k_repack{
    .name = "repack",
    .summary = "work is compacted between stages to keep every lane busy (the thesis, 3.2.2)",
    .stages = kStages,
    .counters = kRasterizerCounters,
    .metrics = kRasterizerMetrics,
    .series = kWorkingSetSeries,
    .instructions = kRasterizerInstructions,
    .widths = kBuiltWidths,
    .start = start_repack,
};

}  // namespace lanescope
