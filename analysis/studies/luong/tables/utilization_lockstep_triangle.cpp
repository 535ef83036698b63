// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/tables/utilization.h"

namespace lanescope::luong {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.1"));
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_utilization_lockstep_triangle{
    "utilization_lockstep_triangle", "table 4.1: utilization of LOCKSTEP by stage, triangles",
    luong::compared<luong::build>};

}  // namespace lanescope
