// SPDX-License-Identifier: MIT
#include "analysis/tables/utilization.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.5"));
}

}  // namespace

extern const Table t_utilization_repack_quad{
    "utilization_repack_quad", "table 4.5: utilization of REPACK by stage, quads", build};

}  // namespace lanescope
