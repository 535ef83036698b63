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

std::vector<TableData> build_tables(const std::vector<const Table*>& tables,
                                    const ReportView& view) {
  std::vector<TableData> built;
  for (const Table* table : tables)
    if (TableData data = build_table(*table, view); !data.rows.empty())
      built.push_back(std::move(data));
  return built;
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

std::string shown_paper(const Figure& figure) {
  if (!figure.paper) return {};
  const Unit& unit = *figure.unit;
  return fmt::format("{}{:.{}f}{}", unit.difference == Difference::kBound ? "<" : "",
                     *figure.paper * unit.scale, unit.paper_decimals, unit.suffix);
}

std::optional<double> rounded_difference(const Figure& figure) {
  if (!figure.ours || !figure.paper) return std::nullopt;
  const Unit& unit = *figure.unit;
  const int decimals = unit.paper_decimals;
  return rounded(*figure.ours * unit.scale, decimals) -
         rounded(*figure.paper * unit.scale, decimals);
}

std::string shown_difference(const Figure& figure) {
  if (!figure.ours || !figure.paper || figure.unit->difference == Difference::kBound) return {};
  if (figure.unit->difference == Difference::kRelative) {
    if (*figure.paper == 0.0) return "n/a";
    // Adding 0 turns a negative zero, which would print as -0, into a positive one.
    return fmt::format("{:+.0f}%", std::round(100.0 * (*figure.ours / *figure.paper - 1.0)) + 0.0);
  }
  return fmt::format("{:+.{}f}", *rounded_difference(figure) + 0.0, figure.unit->paper_decimals);
}

}  // namespace lanescope
