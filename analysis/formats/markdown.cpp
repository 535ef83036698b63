// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/formats/format.h"

namespace lanescope {
namespace {

/// Text that Markdown leaves as it is within a table.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string line(std::string_view label, const std::vector<std::string>& cells,
                 std::size_t columns) {
  std::string text = fmt::format("| {} |", label);
  for (std::size_t i = 0; i < columns; ++i)
    text += fmt::format(" {} |", i < cells.size() ? escaped(cells[i]) : "");
  return text + '\n';
}

std::string write_table(const TableData& data) {
  const WordGrid grid = word_grid(data);
  const std::size_t columns = grid.columns.size();
  std::vector<std::string> headers;
  std::string rule = "| --- |";
  for (const WordGrid::Column& column : grid.columns) {
    headers.push_back(column.header);
    rule += column.words ? " --- |" : " ---: |";
  }
  std::string text =
      fmt::format("### {}\n\nOf: {}\n\n{}{}\n", escaped(data.title), escaped(data.caption),
                  line(escaped(data.row_header), headers, columns), rule);
  for (const WordGrid::Line& row : grid.lines) {
    const std::string label = escaped(row.label);
    text += line(row.heading ? fmt::format("**{}**", label) : label, row.cells, columns);
  }
  for (const std::string& note : data.notes) text += fmt::format("\n{}\n", escaped(note));
  return text;
}

std::string write(const std::vector<TableData>& tables) {
  return write_each(tables, "\n", write_table);
}

}  // namespace

extern const Format f_markdown{"markdown", "tables of GitHub's Markdown", "md", write};

}  // namespace lanescope
