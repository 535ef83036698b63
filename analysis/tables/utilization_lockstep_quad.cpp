// SPDX-License-Identifier: MIT
#include "analysis/tables/utilization.h"

namespace lanescope {
namespace {

TableData build(const ReportView& view) {
  return build_utilization(view, utilization_table("4.4"));
}

}  // namespace

extern const Table t_utilization_lockstep_quad{
    "utilization_lockstep_quad", "table 4.4: utilization of LOCKSTEP by stage, quads", build};

}  // namespace lanescope
