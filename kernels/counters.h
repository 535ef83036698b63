// SPDX-License-Identifier: MIT
// The figures that the rasterizers count beside instructions and lanes.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernels/kernel.h"

namespace lanescope {

/// Positions in kRasterizerCounters. The reference has those up to kHits, LOCKSTEP those up to
/// kConflictHits, REPACK all.
enum RasterizerCounter : std::size_t {
  kSeen,
  kCulled,
  kDegenerate,
  kRasterized,
  kOffScreen,
  kTests,
  kHits,
  kProcessIssued,
  kConflictInvocations,
  kConflictHits,
  kWorkingSetSum,
  kWorkingSetObservations,
  kWorkingSetMaximum,
  kRasterizerCounterCount
};

inline constexpr std::array<CounterInfo, kRasterizerCounterCount> kRasterizerCounters{{
    {"micropolygons_seen", "micropolygons in the packets", "micropolygons"},
    {"micropolygons_culled", "of them, those that face away and were culled", "micropolygons"},
    {"micropolygons_degenerate", "of them, those without area or with one that is not a number",
     "micropolygons"},
    {"micropolygons_rasterized", "of them, those left: seen, not culled, not degenerate",
     "micropolygons"},
    {"micropolygons_off_screen", "of those rasterized, the ones without a candidate sample",
     "micropolygons"},
    {"tests", "PointInPolygon tests", "samples"},
    {"hits", "tests that found the sample covered", "samples"},
    {"process_issued", "invocations of Process", "invocations"},
    {"conflict_invocations", "of them, those in which two lanes hit one sample", "invocations"},
    {"conflict_hits", "hits on a sample that an earlier lane of the same invocation hit",
     "samples"},
    {"working_set_sum", "micropolygons alive just after Bound, summed over its invocations",
     "micropolygons"},
    {"working_set_observations", "invocations of Bound", "invocations"},
    {"working_set_maximum", "most micropolygons alive just after Bound", "micropolygons",
     Merge::kMaximum},
}};

inline constexpr std::array<MetricInfo, 4> kRasterizerMetrics{{
    {"sample_test_efficiency", "hits per test (STE)", "hits", "tests"},
    {"conflicts_per_invocation", "Process invocations with a conflict", "conflict_invocations",
     "process_issued"},
    {"conflicts_per_hit", "hits that conflict with an earlier lane", "conflict_hits", "hits"},
    {"working_set_average", "micropolygons alive just after Bound", "working_set_sum",
     "working_set_observations"},
}};

using RasterizerCounts = std::array<std::uint64_t, kRasterizerCounterCount>;

}  // namespace lanescope
