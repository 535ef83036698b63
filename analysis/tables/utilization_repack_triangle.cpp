// SPDX-License-Identifier: MIT
#include "analysis/tables/utilization.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.2"));
}

}  // namespace

extern const Table t_utilization_repack_triangle{
    "utilization_repack_triangle", "table 4.2: utilization of REPACK by stage, triangles", build};

}  // namespace lanescope
