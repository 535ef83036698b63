// SPDX-License-Identifier: MIT
#include "analysis/tables/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lanescope {
namespace {

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

/// `83% (0.68)` of two texts that may be empty.
std::string with_share(const std::string& figure, const std::string& share) {
  return share.empty() ? figure : fmt::format("{} ({})", figure, share);
}

bool has_content(const Cell& cell) {
  return cell.figure ? cell.figure->ours.has_value() : !cell.words.empty();
}

bool has_content(const TableData& data) {
  return std::any_of(data.rows.begin(), data.rows.end(), [](const Row& row) {
    return std::any_of(row.cells.begin(), row.cells.end(),
                       [](const Cell& cell) { return has_content(cell); });
  });
}

}  // namespace

TableData build_table(const Table& table, const ReportView& view) {
  TableData data = table.build(view);
  data.name = table.name;
  if (data.caption.empty()) data.caption = view.caption();
  data.setting = view.setting();
  return data;
}

std::vector<TableData> build_tables(const std::vector<const Table*>& tables,
                                    const ReportView& view) {
  std::vector<TableData> built;
  for (const Table* table : tables)
    if (TableData data = build_table(*table, view); has_content(data))
      built.push_back(std::move(data));
  return built;
}

std::vector<std::string> width_headers(const std::vector<int>& widths) {
  std::vector<std::string> headers;
  for (const int width : widths) headers.push_back(fmt::format("W = {}", width));
  return headers;
}

std::string shown_subject(const TableData& data) {
  if (data.caption.empty() || data.setting.empty()) return data.caption + data.setting;
  return fmt::format("{}; {}", data.caption, data.setting);
}

std::string shown(const Figure& figure) {
  if (!figure.ours) return "n/a";
  const Unit& unit = *figure.unit;
  return fmt::format("{:.{}f}{}", *figure.ours * unit.scale, unit.decimals, unit.suffix);
}

std::string shown(const Cell& cell) {
  if (!cell.figure) return cell.words;
  return with_share(shown(*cell.figure), cell.share ? shown(*cell.share) : "");
}

std::string shown_paper(const Figure& figure) {
  if (!figure.paper) return {};
  if (!figure.comparable) return std::string(kNotComparable);
  const Unit& unit = *figure.unit;
  return fmt::format("{}{:.{}f}{}", unit.difference == Difference::kBound ? "<" : "",
                     *figure.paper * unit.scale, unit.paper_decimals, unit.suffix);
}

std::string shown_paper(const Cell& cell) {
  if (!cell.figure) return {};
  const bool has_share = cell.share && cell.share->comparable;
  return with_share(shown_paper(*cell.figure), has_share ? shown_paper(*cell.share) : "");
}

bool has_difference(const Figure& figure) {
  return figure.ours && figure.paper && figure.comparable &&
         figure.unit->difference != Difference::kBound;
}

std::optional<double> rounded_difference(const Figure& figure) {
  if (!has_difference(figure)) return std::nullopt;
  const Unit& unit = *figure.unit;
  const int decimals = unit.paper_decimals;
  return rounded(*figure.ours * unit.scale, decimals) -
         rounded(*figure.paper * unit.scale, decimals);
}

std::string shown_difference(const Figure& figure) {
  if (!has_difference(figure)) return {};
  if (figure.unit->difference == Difference::kRelative) {
    if (*figure.paper == 0.0) return "n/a";
    // Adding 0 turns a negative zero, which would print as -0, into a positive one.
    return fmt::format("{:+.0f}%", std::round(100.0 * (*figure.ours / *figure.paper - 1.0)) + 0.0);
  }
  const double difference = *rounded_difference(figure);
  if (figure.unit->difference == Difference::kPoints)
    return fmt::format("{:+.0f}", std::round(100.0 * difference) + 0.0);
  return fmt::format("{:+.{}f}", difference + 0.0, figure.unit->paper_decimals);
}

std::string shown_difference(const Cell& cell) {
  if (!cell.figure) return {};
  return with_share(shown_difference(*cell.figure),
                    cell.share ? shown_difference(*cell.share) : "");
}

}  // namespace lanescope
