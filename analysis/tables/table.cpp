// SPDX-License-Identifier: MIT
#include "analysis/tables/table.h"

#include <fmt/format.h>

#include <cmath>

namespace lanescope {
namespace {

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

}  // namespace

TableData build_table(const Table& table, const ReportView& view) {
  TableData data = table.build(view);
  data.name = table.name;
  if (data.caption.empty()) data.caption = view.caption();
  return data;
}

std::string shown(const Figure& figure) {
  if (!figure.ours) return "n/a";
  const Unit& unit = *figure.unit;
  return fmt::format("{:.{}f}{}", *figure.ours * unit.scale, unit.decimals, unit.suffix);
}

std::string shown(const Cell& cell) {
  if (!cell.figure) return cell.words;
  std::string text = shown(*cell.figure);
  if (cell.share) text += fmt::format(" ({})", shown(*cell.share));
  return text;
}

std::string shown_thesis(const Figure& figure) {
  if (!figure.thesis) return {};
  const Unit& unit = *figure.unit;
  return fmt::format("{}{:.{}f}{}", unit.difference == Difference::kBound ? "<" : "",
                     *figure.thesis * unit.scale, unit.thesis_decimals, unit.suffix);
}

std::optional<double> rounded_difference(const Figure& figure) {
  if (!figure.ours || !figure.thesis) return std::nullopt;
  const Unit& unit = *figure.unit;
  const int decimals = unit.thesis_decimals;
  return rounded(*figure.ours * unit.scale, decimals) -
         rounded(*figure.thesis * unit.scale, decimals);
}

std::string shown_difference(const Figure& figure) {
  if (!figure.ours || !figure.thesis || figure.unit->difference == Difference::kBound) return {};
  if (figure.unit->difference == Difference::kRelative) {
    if (*figure.thesis == 0.0) return "n/a";
    // Adding 0 turns a negative zero, which would print as -0, into a positive one.
    return fmt::format("{:+.0f}%", std::round(100.0 * (*figure.ours / *figure.thesis - 1.0)) + 0.0);
  }
  return fmt::format("{:+.{}f}", *rounded_difference(figure) + 0.0, figure.unit->thesis_decimals);
}

}  // namespace lanescope
