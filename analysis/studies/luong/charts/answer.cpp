// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/html/charts/answer_table.h"
#include "analysis/html/section.h"
#include "analysis/studies/luong/charts/pairs.h"
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/study.h"
#include "analysis/studies/luong/tables/deviation.h"
#include "analysis/studies/luong/tables/utilization.h"

namespace lanescope::luong {
namespace {

/// `At W = 64 it issues 9.79 for each micropolygon against 10.56 (7% fewer).`
std::string widest_sentence(const ReportView& view, const Pair& pair) {
  const int width = ratios(view, pair).back().width;
  const double lockstep = *instructions(view, pair.lockstep, width);
  const double repack = *instructions(view, pair.repack, width);
  return fmt::format("At W = {}, REPACK issues {:.2f} for each micropolygon against {:.2f} ({}).",
                     width, repack, lockstep, shown_change(repack, lockstep));
}

/// `REPACK keeps 94% of the lanes busy at W = 8 and 88% at W = 64`
std::string busy_part(const ReportView& view, const Series& series, std::string_view name) {
  const std::vector<int> widths = view.widths(series);
  std::string text;
  for (const int width : {widths.front(), widths.back()}) {
    const auto busy = overall_utilization(view, series, width);
    if (!busy || (!text.empty() && widths.size() == 1)) continue;
    text += fmt::format("{}{:.0f}%{} at W = {}", text.empty() ? "" : " and ", 100.0 * *busy,
                        text.empty() ? " of the lanes busy" : "", width);
  }
  return fmt::format("{} keeps {}", name, text);
}

std::string busy_sentence(const ReportView& view, const Pair& pair) {
  return fmt::format("On {}, {}; {}.", plural(pair.lockstep.facet),
                     busy_part(view, pair.lockstep, "LOCKSTEP"),
                     busy_part(view, pair.repack, "REPACK"));
}

/// `Against the thesis, on triangles: utilization of the stages is at most 2 points from its
/// tables, 0.85 points root mean square; their shares of the instructions are at most 11, 5.21.`
std::string deviation_sentence(const ReportView& view, std::string_view facet) {
  const Deviation deviation = stage_deviation(view, facet);
  const Deviation shares = share_deviation(view, facet);
  const auto root = deviation.root_mean_square(deviation.rounded_squares);
  if (!root) return {};
  return fmt::format(
      "Against the thesis, on {}: utilization of the stages is at most {:.0f} points from its "
      "tables, {:.2f} points root mean square; their shares of the instructions are at most "
      "{:.0f}, "
      "{:.2f}.",
      plural(facet), std::abs(deviation.largest), *root, std::abs(shares.largest),
      shares.root_mean_square(shares.rounded_squares).value_or(0.0));
}

std::vector<SectionBlock> build(const ReportView& view) {
  std::vector<std::string> sentences;
  for (const Pair& pair : pairs_of(view)) {
    sentences.push_back(crossing_sentence(view, pair) + ' ' + widest_sentence(view, pair));
    sentences.push_back(busy_sentence(view, pair));
  }
  if (sentences.empty()) sentences = ranking_sentences(view, kAllButSetup);
  if (differences_from_thesis(view).empty())
    for (const std::string_view facet : {kTriangle, kQuad})
      if (std::string text = deviation_sentence(view, facet); !text.empty())
        sentences.push_back(std::move(text));
  Markup table = answer_table(view, kAllButSetup,
                              "Utilization is active lanes / (instructions x W); of all stages but "
                              "Setup, as the thesis sums.");
  return {findings(sentences), std::move(table)};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_answer{"answer", "The answer", "", luong::build};

}  // namespace lanescope
