// SPDX-License-Identifier: MIT
// Our figures with the keys and the shape of data/thesis-tables.json, so that a script can
// lay the two side by side.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/tables/report_view.h"

namespace lanescope::luong {

/// Widths are the thesis's; figures that the report does not give are null. Conflicts are of
/// Process invocations, the larger of the two kernels. The claims are measured as in the table
/// `claims`.
nlohmann::ordered_json thesis_json(const ReportView& view);

}  // namespace lanescope::luong
