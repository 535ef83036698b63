// SPDX-License-Identifier: MIT
#include "analysis/tables/utilization.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.1"));
}

}  // namespace

extern const Table t_utilization_lockstep_triangle{
    "utilization_lockstep_triangle", "table 4.1: utilization of LOCKSTEP by stage, triangles",
    build};

}  // namespace lanescope
