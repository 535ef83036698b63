// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

using Conflicts = std::optional<double> (*)(const ReportView&, const Series&, int);

void add_block(TableData& data, const ReportView& view, const std::string& heading,
               Conflicts conflicts) {
  data.rows.push_back({heading, {}});
  for (const Series& series : {kLockstepTriangle, kLockstepQuad, kRepackTriangle, kRepackQuad}) {
    Row row{fmt::format("{}, {}", series.kernel, plural(series.facet)), {}};
    for (const int width : widths_of(view, kLockstepTriangle)) {
      const auto thesis =
          width == 64 ? thesis_value({"text_claims", "conflict_rate_max_at_w64"}) : std::nullopt;
      row.cells.push_back({Figure{conflicts(view, series, width), thesis, &kSmallPercent}, {}, {}});
    }
    data.rows.push_back(std::move(row));
  }
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "Conflicts in Process: two lanes that hit one sample";
  data.row_header = "Kernel";
  data.columns = width_headers(widths_of(view, kLockstepTriangle));
  add_block(data, view, "Of all invocations of Process, those with a conflict",
            conflicting_invocations);
  add_block(data, view, "Of all hits, those on a sample that an earlier lane of the invocation hit",
            conflicting_hits);
  data.notes = {
      "The thesis says that conflicts occur less than 1% of the times at W = 64, and not "
      "of what."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_conflicts{"conflicts",
                                     "lanes that hit one sample at once, by two denominators",
                                     luong::compared<luong::build>};

}  // namespace lanescope
