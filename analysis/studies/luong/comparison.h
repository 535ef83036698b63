// SPDX-License-Identifier: MIT
// Whether figures are of what the thesis measured: only then do its numbers stand beside ours.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/tables/report_view.h"
#include "analysis/tables/table.h"

namespace lanescope::luong {

/// The setting of runs, with the keys of `setup` in data/thesis-tables.json.
nlohmann::ordered_json setup_json(const Configuration& configuration,
                                  const std::vector<std::string>& scenes);

/// What of the view's runs is not as in the thesis, which gives means of its four scenes in one
/// setting: `resolution is 480x300 (thesis: 1728x1080)`. Empty if figures can be compared.
std::vector<std::string> differences_from_thesis(const ReportView& view);

/// Marks the figures of a table as not comparable, unless they are, and says why below it if it has
/// anything of the thesis beside them.
TableData beside_thesis(const ReportView& view, TableData data);

/// Builds a table of the study: `build`, beside the thesis.
template <TableData (*kBuild)(const ReportView&)>
TableData compared(const ReportView& view) {
  return beside_thesis(view, kBuild(view));
}

}  // namespace lanescope::luong
