// SPDX-License-Identifier: MIT
// What the charts of the page share: which stages and widths a report has, and the pieces of
// Vega-Lite specifications that show them alike everywhere.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/html/data_frame.h"
#include "analysis/html/section.h"
#include "analysis/tables/report_view.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {

/// The stages of a report: those of kernels in the order in which all pictures show them, then
/// others as they occur.
std::vector<std::string> stages_of(const Report& report);

/// The kernels of a report, as shown_kernel() has them.
std::vector<std::string> kernels_of(const Report& report);
/// The facets of a report, as shown_facet() has them.
std::vector<std::string> facets_of(const Report& report);
/// The scenes that figures are of: `ballroll, talking`.
std::string shown_scenes(const ReportView& view);
/// What the report's instructions are divided by, as Element has it.
struct ElementWords {
  std::string name, abbreviation;
};
ElementWords element_of(const Report& report);

/// Widths for charts that have room for a few: all, or the powers of two if there are too many.
std::vector<int> few_widths(const std::vector<int>& widths);

/// The columns that name a run of a mean over scenes: `kernel`, `facet`, `lanes` (W).
std::vector<DataColumn> series_columns(std::vector<DataColumn> others);

/// A Vega-Lite specification from its text, in which `"@stage"` stands for the colour of a stage,
/// `"@lanes"` for an axis of W (on a logarithmic scale; on a linear one if there are many), `"@W"`
/// for one of bars, `"@point"` and `"@ink_point"` for the points of a line over W, and `"@stages"`,
/// `"@kernels"`,
/// `"@facets"` and `"@scenes"` for those of the report in order (facets of charts are sorted by
/// name otherwise). Requires that it is JSON.
nlohmann::ordered_json spec_from(std::string_view text, const Report& report);

/// `panel` for the rows whose `field` is `value`, which becomes its title. For panels with scales
/// of their own, which facets of Vega-Lite lay out wrongly.
nlohmann::ordered_json panel_for(nlohmann::ordered_json panel, std::string_view field,
                                 const std::string& value);

/// A pick of one W of the report; begins with 16, the usual one, or the narrowest.
Pick pick_of_lanes(const Report& report);
/// Of the facet, and of the kernel.
Pick pick_of_facet();
Pick pick_of_kernel();

}  // namespace lanescope
