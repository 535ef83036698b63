// SPDX-License-Identifier: MIT
// The figures that the rasterizers count beside instructions and lanes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

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

inline constexpr std::string_view kPartsOfSeen[] = {
    "micropolygons_culled", "micropolygons_degenerate", "micropolygons_rasterized"};
inline constexpr CounterSum kRasterizerSums[] = {{"micropolygons_seen", kPartsOfSeen}};

/// What the instructions of a rasterizer are divided by.
inline constexpr Element kMicropolygon{"micropolygons_rasterized", "micropolygon", "mp"};

inline constexpr std::array<MetricInfo, 4> kRasterizerMetrics{{
    {"sample_test_efficiency", "hits per test (STE)", "hits", "tests"},
    {"conflicts_per_invocation", "Process invocations with a conflict", "conflict_invocations",
     "process_issued"},
    {"conflicts_per_hit", "hits that conflict with an earlier lane", "conflict_hits", "hits"},
    {"working_set_average", "micropolygons alive just after Bound", "working_set_sum",
     "working_set_observations"},
}};

/// Of the working set, in the order of WorkingSetCourse::series.
inline constexpr std::array<SeriesInfo, 3> kWorkingSetSeries{{
    {"working_set_histogram", "invocations of Bound after which so many micropolygons were alive",
     "micropolygons", "invocations"},
    {"working_set_course_sum",
     "micropolygons alive just after the n-th Bound of a packet, summed over packets",
     "invocation of Bound in its packet", "micropolygons"},
    {"working_set_course_packets", "packets that had an n-th Bound",
     "invocation of Bound in its packet", "packets"},
}};

/// The working set as a histogram, and in its course over a packet.
class WorkingSetCourse {
 public:
  void begin_packet() { place_ = 0; }

  void observe(std::uint64_t alive) {
    increase(histogram_, static_cast<std::size_t>(alive), 1);
    increase(sum_, place_, alive);
    increase(packets_, place_, 1);
    ++place_;
  }

  std::vector<std::vector<std::uint64_t>> series() const { return {histogram_, sum_, packets_}; }

 private:
  static void increase(std::vector<std::uint64_t>& list, std::size_t place, std::uint64_t by) {
    if (place >= list.size()) list.resize(place + 1);
    list[place] += by;
  }

  std::size_t place_ = 0;
  std::vector<std::uint64_t> histogram_, sum_, packets_;
};

using RasterizerCounts = std::array<std::uint64_t, kRasterizerCounterCount>;

}  // namespace lanescope
