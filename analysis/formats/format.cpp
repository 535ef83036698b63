// SPDX-License-Identifier: MIT
#include "analysis/formats/format.h"

#include <algorithm>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

bool any_cell(const TableData& data, std::size_t column, bool (*holds)(const Cell&)) {
  return std::any_of(data.rows.begin(), data.rows.end(), [&](const Row& row) {
    return column < row.cells.size() && holds(row.cells[column]);
  });
}

bool has_paper(const Cell& cell) { return !shown_paper(cell).empty(); }
bool is_compared(const Cell& cell) { return has_paper(cell) && cell.figure->comparable; }
bool has_words(const Cell& cell) { return !cell.words.empty(); }

/// What of a paper stands beside one column of a table.
struct Beside {
  bool paper;
  bool difference;
};

WordGrid::Line line_of(const Row& row, const std::vector<Beside>& beside) {
  WordGrid::Line line{row.label, row.cells.empty(), {}};
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const Cell& cell = row.cells[i];
    line.cells.push_back(shown(cell));
    if (beside[i].paper) line.cells.push_back(shown_paper(cell));
    if (beside[i].difference) line.cells.push_back(shown_difference(cell));
  }
  return line;
}

}  // namespace

std::string write_each(const std::vector<TableData>& tables, std::string_view gap,
                       std::string (*write_table)(const TableData& data)) {
  std::string text;
  for (const TableData& data : tables) {
    if (!text.empty()) text += gap;
    text += write_table(data);
  }
  return text;
}

const Format& find_format(std::string_view name) {
  const auto& all = formats();
  const auto found = std::find_if(all.begin(), all.end(), [&](auto* f) { return f->name == name; });
  LANESCOPE_CHECK(found != all.end(), "format {}", name);
  return **found;
}

WordGrid word_grid(const TableData& data) {
  WordGrid grid;
  std::vector<Beside> beside;
  for (std::size_t i = 0; i < data.columns.size(); ++i) {
    beside.push_back({any_cell(data, i, has_paper), any_cell(data, i, is_compared)});
    grid.columns.push_back({data.columns[i], true, any_cell(data, i, has_words)});
    if (beside.back().paper) grid.columns.push_back({"paper", false});
    if (beside.back().difference) grid.columns.push_back({"diff", false});
  }
  for (const Row& row : data.rows) grid.lines.push_back(line_of(row, beside));
  return grid;
}

}  // namespace lanescope
