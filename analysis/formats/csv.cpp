// SPDX-License-Identifier: MIT
// Tidy data: one line for each figure, unscaled and unrounded, for notebooks.
#include <fmt/format.h>

#include "analysis/base/csv_text.h"
#include "analysis/formats/format.h"

namespace lanescope {
namespace {

std::string number(std::optional<double> value) { return value ? fmt::format("{}", *value) : ""; }

struct Place {
  const TableData& table;
  std::string group;  ///< The heading above the row, if any.
  std::string row;
  std::string column;
};

std::string line(const Place& place, std::string_view quantity, const Figure& figure,
                 std::string_view words) {
  const auto paper = figure.comparable ? figure.paper : std::nullopt;
  const auto difference =
      figure.ours && paper ? std::optional(*figure.ours - *paper) : std::nullopt;
  return csv_line({place.table.name, place.table.caption, place.table.setting, place.group,
                   place.row, place.column, std::string(quantity),
                   words.empty() ? std::string(figure.unit->name) : "", number(figure.ours),
                   number(paper), number(difference), std::string(words)});
}

std::string cell_lines(const Place& place, const Cell& cell) {
  if (!cell.figure) return cell.words.empty() ? "" : line(place, "words", {}, cell.words);
  std::string lines = line(place, "figure", *cell.figure, "");
  if (cell.share) lines += line(place, "share", *cell.share, "");
  return lines;
}

std::string table_lines(const TableData& data) {
  std::string lines;
  std::string group;
  for (const Row& row : data.rows) {
    if (row.cells.empty()) group = row.label;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      lines += cell_lines({data, group, row.label, data.columns[i]}, row.cells[i]);
  }
  return lines;
}

std::string write(const std::vector<TableData>& tables) {
  std::string text =
      "table,scenes,setting,group,row,column,quantity,unit,ours,paper,difference,words\n";
  for (const TableData& data : tables) text += table_lines(data);
  return text;
}

}  // namespace

extern const Format f_csv{"csv", "one line for each figure, unscaled and unrounded", "csv", write};

}  // namespace lanescope
