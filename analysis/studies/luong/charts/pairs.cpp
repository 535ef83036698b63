// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/charts/pairs.h"

#include <fmt/format.h>

#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {

std::vector<Pair> pairs_of(const ReportView& view) {
  std::vector<Pair> pairs;
  for (const Pair& pair :
       {Pair{kLockstepTriangle, kRepackTriangle}, Pair{kLockstepQuad, kRepackQuad}})
    if (!ratios(view, pair).empty()) pairs.push_back(pair);
  return pairs;
}

std::vector<CostRatio> ratios(const ReportView& view, const Pair& pair) {
  std::vector<CostRatio> list;
  for (const int width : view.widths(pair.lockstep))
    if (const auto ratio = quotient(instructions(view, pair.repack, width),
                                    instructions(view, pair.lockstep, width)))
      list.push_back({width, *ratio});
  return list;
}

std::string crossing_sentence(const ReportView& view, const Pair& pair) {
  const std::vector<CostRatio> list = ratios(view, pair);
  const std::string shape = plural(pair.lockstep.facet);
  if (const auto width = crossing_point(list)) {
    const bool wins_above = list.front().ratio > 1.0;
    return fmt::format(
        "On {}, LOCKSTEP and REPACK cross at W = {:.1f}: REPACK issues fewer instructions {} it.",
        shape, *width, wins_above ? "above" : "below");
  }
  return fmt::format("On {}, REPACK issues {} instructions than LOCKSTEP at every W measured.",
                     shape, list.front().ratio > 1.0 ? "more" : "fewer");
}

}  // namespace lanescope::luong
