// SPDX-License-Identifier: MIT
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  return table_over_widths(view, "Counters", "Counter", counter_rows);
}

}  // namespace

extern const Table t_counters{"counters", "what kernels count beside instructions and lanes",
                              build};

}  // namespace lanescope
