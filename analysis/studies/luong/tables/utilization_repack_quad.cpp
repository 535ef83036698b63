// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/tables/utilization.h"

namespace lanescope::luong {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.5"));
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_utilization_repack_quad{
    "utilization_repack_quad", "table 4.5: utilization of REPACK by stage, quads",
    luong::compared<luong::build>};

}  // namespace lanescope
