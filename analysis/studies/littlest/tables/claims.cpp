// SPDX-License-Identifier: MIT
// What the article and its comments say, against our figures.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/studies/littlest/figures.h"
#include "analysis/tables/series_rows.h"

namespace lanescope::littlest {
namespace {

/// Three faces of eight words: as many lanes as the article's code has at work.
constexpr int kArticlesLanes = 24;

std::string verdict(std::optional<bool> holds) { return !holds ? "n/a" : *holds ? "yes" : "no"; }

Row claim(std::string label, Figure figure, std::optional<bool> holds) {
  return {std::move(label), {Cell{figure, {}, {}}, Cell{{}, {}, verdict(holds)}}};
}

int nearest_width(const ReportView& view, const Series& series) {
  int nearest = 0;
  for (const int width : view.widths(series))
    if (nearest == 0 || std::abs(width - kArticlesLanes) < std::abs(nearest - kArticlesLanes))
      nearest = width;
  return nearest;
}

/// "This conversion is actually the slowest part of the whole technique".
Row slowest_part(const ReportView& view, const Series& series, int width) {
  const auto share = mean_stage_share(view, series, kProject, width);
  return claim(fmt::format("the conversion takes more than the rendering: its share, {}, W = {}",
                           shown(series), width),
               {share, 0.5, &kPercent}, share ? std::optional(*share > 0.5) : std::nullopt);
}

/// "With the sampling set up properly, the conversion to SH would then be nothing but counting".
Row counting_only(const ReportView& view, std::string_view kernel, int width) {
  const Series faces{std::string(kernel), std::string(kFaces)};
  const Series directions{std::string(kernel), std::string(kDirections)};
  const auto times = quotient(stage_per_octant(view, faces, kProject, width),
                              stage_per_octant(view, directions, kProject, width));
  return claim(fmt::format("counting makes the conversion cheaper: times, {}, W = {}",
                           shown_kernel(kernel), width),
               {times, {}, &kFactor}, times ? std::optional(*times > 1.0) : std::nullopt);
}

/// "First-order harmonics - just 4 floats - because I think it looks fine".
Row looks_fine(const ReportView& view) {
  const auto order = root_mean_square(view, kFaces, "squared_order_error", "lights");
  const auto sampling = root_mean_square(view, kFaces, "squared_sampling_error", "lights");
  std::optional<bool> holds;
  if (order && sampling) holds = *sampling < *order;
  return claim("16 x 16 pixels lose less light than ending at the first order: error of the pixels",
               {sampling, {}, &kPercent}, holds);
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "What the article says, and what is found";
  data.row_header = "Claim";
  const Series form{std::string(kArticlesForm), std::string(kFaces)};
  const int width = nearest_width(view, form);
  if (width == 0) return data;
  data.columns = {"Figure", "Holds"};
  data.rows.push_back(slowest_part(view, form, width));
  for (const Series& series : programs_of(view.report(), kFaces))
    if (series.kernel != kArticlesForm) data.rows.push_back(slowest_part(view, series, width));
  for (const Series& series : programs_of(view.report(), kFaces))
    data.rows.push_back(counting_only(view, series.kernel, width));
  data.rows.push_back(looks_fine(view));
  data.notes = {
      "The article's own figures are times of scalar control and SSE on a Core 2; ours are vector "
      "instructions. Its rate, about 100 harmonics a millisecond, is compared in "
      "docs/voxels.md."};
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_claims{"claims", "what the article says, and what is found",
                                     littlest::build};

}  // namespace lanescope
