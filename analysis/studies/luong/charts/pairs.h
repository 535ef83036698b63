// SPDX-License-Identifier: MIT
// LOCKSTEP beside REPACK, which is what the thesis compares.
#pragma once

#include <string>
#include <vector>

#include "analysis/tables/crossing.h"
#include "analysis/tables/report_view.h"

namespace lanescope::luong {

/// Both on one kind of micropolygon.
struct Pair {
  Series lockstep, repack;
};

/// The pairs of which a report has a width of both.
std::vector<Pair> pairs_of(const ReportView& view);

/// Instructions of REPACK over those of LOCKSTEP, at each width that both were run at.
std::vector<CostRatio> ratios(const ReportView& view, const Pair& pair);

/// `On triangles, the two cross at W = 23.4: REPACK issues fewer instructions above it.`
std::string crossing_sentence(const ReportView& view, const Pair& pair);

}  // namespace lanescope::luong
