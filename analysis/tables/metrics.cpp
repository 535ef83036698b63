// SPDX-License-Identifier: MIT
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  return table_over_widths(view, "Metrics: ratios of counters", "Metric", metric_rows);
}

}  // namespace

extern const Table t_metrics{"metrics", "ratios that kernels declare", build};

}  // namespace lanescope
