// SPDX-License-Identifier: MIT
// Charts of sections, and what is in their rows.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "analysis/html/section.h"

namespace lanescope::testing {

/// The chart of one of the sections; fails the test if there is none.
Chart chart_of(const std::vector<const Section*>& sections, const ReportView& view,
               std::string_view section_id, std::string_view chart_id);

/// The last value of the row that begins with these values, or one before it.
nlohmann::ordered_json last_of(const Chart& chart, const std::vector<nlohmann::ordered_json>& begin,
                               std::size_t from_end = 0);

}  // namespace lanescope::testing
