// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/studies/littlest/figures.h"

namespace lanescope::littlest {
namespace {

struct ErrorRow {
  std::string_view label, counter, count;
};
constexpr ErrorRow kRows[] = {
    {"harmonics, by the samples", "squared_harmonics_error", "probes"},
    {"light, by the samples", "squared_sampling_error", "lights"},
    {"light, by ending at the first order", "squared_order_error", "lights"},
    {"light, by both", "squared_total_error", "lights"},
};

TableData build(const ReportView& view) {
  const Report& report = view.report();
  TableData data;
  data.title = "Root mean square errors of harmonics and of light, against 4096 rays of each probe";
  data.caption = "each world by itself";
  data.row_header = "Error";
  const std::vector<std::string> scenes = scenes_and_filled(view);
  data.columns = scenes;
  for (const std::string_view projection : {kFaces, kDirections}) {
    if (!root_mean_square(ReportView(report, scenes.front()), projection, kRows[0].counter,
                          kRows[0].count))
      continue;
    data.rows.push_back({fmt::format("projection = {}", projection), {}});
    for (const ErrorRow& error : kRows) {
      Row row{std::string(error.label), {}};
      for (const std::string& scene : scenes)
        row.cells.push_back({Figure{root_mean_square(ReportView(report, scene), projection,
                                                     error.counter, error.count),
                                    {},
                                    &kPercent},
                             {},
                             {}});
      data.rows.push_back(std::move(row));
    }
  }
  data.notes = {
      "In percent of an open sky: of the harmonics' length there, and of the light that a surface "
      "receives from it. Light is that of a white sky on six surfaces at each probe, towards each "
      "axis either way. The error of the first order is the same for both projections."};
  if (data.rows.empty()) data.columns.clear();
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_errors{
    "errors", "errors of both projections and of the first order, against 4096 rays",
    littlest::build};

}  // namespace lanescope
