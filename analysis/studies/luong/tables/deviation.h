// SPDX-License-Identifier: MIT
// How far utilization and shares are from the thesis's tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/tables/table.h"

namespace lanescope::luong {

/// Differences of utilizations or of shares, in points, gathered cell by cell.
struct Deviation {
  int cells = 0;
  double largest = 0.0;  ///< With its sign; of numbers rounded as the thesis rounds.
  std::string where = "-";
  double rounded_squares = 0.0;
  double exact_squares = 0.0;

  void add(const Figure& figure, const std::string& place);
  /// Of either sum of squares; none without cells.
  std::optional<double> root_mean_square(double squares) const;
};

/// Of the utilization of the stages in the thesis's tables of triangles, or of quads.
Deviation stage_deviation(const ReportView& view, std::string_view facet);
/// Of their shares of the instructions.
Deviation share_deviation(const ReportView& view, std::string_view facet);

}  // namespace lanescope::luong
