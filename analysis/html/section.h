// SPDX-License-Identifier: MIT
// The contract of a section of the page: a name, a title, a sentence, and a pure function of a
// report that gives charts and markup.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/html/data_frame.h"
#include "analysis/tables/report_view.h"

namespace lanescope {

/// A piece of HTML. Whoever makes it escapes what comes from the report (analysis/html/markup.h).
struct Markup {
  std::string html;
};

/// A chart and its figures. The page draws the Vega-Lite specification with the rows as its data,
/// and shows the same rows as a table.
struct Chart {
  std::string id;       ///< Unique within the section; letters, digits and hyphens.
  std::string caption;  ///< What is seen and of which scenes; a sentence or two.
  nlohmann::ordered_json spec;
  DataFrame rows;
};

using Block = std::variant<Markup, Chart>;

/// The descriptor; analysis/html/charts/<name>.cpp ends in one, and the registry lists them.
/// Studies have sections of their own.
struct Section {
  std::string_view id;  ///< Of the heading, to link to; letters, digits and hyphens.
  std::string_view title;
  std::string_view explanation;  ///< One sentence.
  /// Figures of one setting of an experiment: every run differs from the others in kernel, width,
  /// facet or scene. `view` has the scenes that figures are averaged over. Without blocks, or with
  /// charts that have no rows, the page says that the report has no such figures.
  std::vector<Block> (*build)(const ReportView& view);
};

/// Every section that any run can have, in the order of analysis/html/charts/CMakeLists.txt.
const std::vector<const Section*>& sections();

}  // namespace lanescope
