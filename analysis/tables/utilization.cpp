// SPDX-License-Identifier: MIT
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  TableData data = table_over_widths(view, "Utilization of each stage (share of the instructions)",
                                     "Stage", utilization_rows);
  data.notes = {"Utilization is active lanes / (instructions x W). Shares are of all stages."};
  return data;
}

}  // namespace

extern const Table t_utilization{
    "utilization", "utilization of each stage, and its share of the instructions", build};

}  // namespace lanescope
