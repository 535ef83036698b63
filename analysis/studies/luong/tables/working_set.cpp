// SPDX-License-Identifier: MIT

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

using WorkingSet = std::optional<double> (*)(const ReportView&, const Series&, int);

Row working_set_row(const ReportView& view, const std::string& label, const Series& series,
                    WorkingSet working_set, std::string_view thesis_name) {
  Row row{label, {}};
  for (const int width : widths_of(view, kRepackTriangle)) {
    const auto thesis = thesis_value({"text_claims", "repack_working_set_over_width", thesis_name});
    row.cells.push_back({Figure{working_set(view, series, width), thesis, &kWidths}, {}, {}});
  }
  return row;
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "REPACK: working set, in multiples of the width";
  data.row_header = "Micropolygons alive";
  data.columns = width_headers(widths_of(view, kRepackTriangle));
  for (const Series& series : {kRepackTriangle, kRepackQuad}) {
    data.rows.push_back(working_set_row(view, "Average, " + plural(series.facet), series,
                                        average_working_set, "average"));
    data.rows.push_back(working_set_row(view, "Maximum, " + plural(series.facet), series,
                                        largest_working_set, "maximum"));
  }
  data.notes = {
      "Micropolygons whose vertices REPACK still has to keep, observed as the kernel "
      "defines it. The maximum is over all scenes."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_working_set{"working_set", "micropolygons that REPACK keeps in flight",
                                       luong::compared<luong::build>};

}  // namespace lanescope
