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

/// A column of a chart's rows whose value the reader picks beside the chart; a single value is only
/// named.
struct Pick {
  std::string column;
  nlohmann::ordered_json first;  ///< What it begins with; the first of the rows if they lack it.

  bool operator==(const Pick&) const = default;
};

/// A chart and its figures. The page draws the Vega-Lite specification with the rows that have the
/// values picked as its data, and shows the same rows as a table; a download has all of them. Of
/// scales that name colours for values, those that rows have stay.
struct Chart {
  std::string id;       ///< Unique within the section; letters, digits and hyphens.
  std::string caption;  ///< What is seen and of which scenes; a sentence or two.
  nlohmann::ordered_json spec;
  DataFrame rows;
  std::vector<Pick> picks = {};
};

using SectionBlock = std::variant<Markup, Chart>;

/// The descriptor; analysis/html/charts/<name>.cpp ends in one, and the registry lists them.
/// Studies have sections of their own.
struct Section {
  std::string_view id;  ///< Of the heading, to link to; letters, digits and hyphens.
  std::string_view title;
  std::string_view explanation;  ///< One sentence; perhaps none.
  /// Figures of one setting of an experiment: every run differs from the others in kernel, width,
  /// facet or scene. `view` has the scenes that figures are averaged over. Without blocks, or with
  /// charts that have no rows, the page leaves the section out and says so. The page shows one
  /// setting at a time: blocks of several settings stand in one place, charts by their id.
  std::vector<SectionBlock> (*build)(const ReportView& view);
};

/// Every section that any run can have, in the order of analysis/html/charts/CMakeLists.txt.
const std::vector<const Section*>& sections();

}  // namespace lanescope
