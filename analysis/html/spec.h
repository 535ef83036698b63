// SPDX-License-Identifier: MIT
// What the charts of the page share: which series, stages and widths a report has, and the pieces
// of Vega-Lite specifications that show them alike everywhere.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/html/data_frame.h"
#include "analysis/tables/report_view.h"

namespace lanescope {

/// The kernels of a report on its kinds of micropolygon, kernels in the order of their first runs,
/// triangles first. Names are views into the report.
std::vector<Series> series_of(const Report& report);

/// Stages that have a colour: Setup, the thesis's in its order, then others as they occur.
std::vector<std::string> stages_of(const Report& report);

/// All widths of a report, ascending.
std::vector<int> widths_of(const Report& report);

/// `LOCKSTEP`, as the thesis writes kernels.
std::string shown_kernel(std::string_view kernel);
/// The kernels of a report, shown so.
std::vector<std::string> kernels_of(const Report& report);
/// The scenes that figures are of: `ballroll, talking`.
std::string shown_scenes(const ReportView& view);
/// `triangles`.
std::string shown_shape(Micropolygon shape);

/// A number, or null.
nlohmann::ordered_json number_or_null(const std::optional<double>& value);

/// The columns that name a run of a mean over scenes: `kernel`, `micropolygon`, `lanes` (W).
std::vector<DataColumn> series_columns(std::vector<DataColumn> others);

/// A Vega-Lite specification from its text, in which `"@stage"` stands for the colour of a stage,
/// `"@lanes"` for an axis of W on a logarithmic scale, and `"@stages"`, `"@kernels"` and
/// `"@scenes"` for those of the report in order (facets are sorted by name otherwise). Requires
/// that it is JSON.
nlohmann::ordered_json spec_from(std::string_view text, const Report& report);

/// `panel` for the rows whose `field` is `value`, which becomes its title. For panels with scales
/// of their own, which facets of Vega-Lite lay out wrongly.
nlohmann::ordered_json panel_for(nlohmann::ordered_json panel, std::string_view field,
                                 const std::string& value);

/// A selection beside the chart: the parameter `name`, and the value it begins with.
nlohmann::ordered_json choice(std::string_view name, std::string_view label,
                              const nlohmann::ordered_json& options,
                              const nlohmann::ordered_json& first);
/// Of one W of the report; begins with 16, which the thesis measures at, or the narrowest.
nlohmann::ordered_json choice_of_lanes(const Report& report);
/// Of the kind of micropolygon.
nlohmann::ordered_json choice_of_shape(const Report& report);
/// Of the kernel.
nlohmann::ordered_json choice_of_kernel(const Report& report);

}  // namespace lanescope
