// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/tables/utilization.h"

namespace lanescope::luong {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.2"));
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_utilization_repack_triangle{
    "utilization_repack_triangle", "table 4.2: utilization of REPACK by stage, triangles",
    luong::compared<luong::build>};

}  // namespace lanescope
