// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/base/markdown_text.h"
#include "analysis/formats/format.h"

namespace lanescope {
namespace {

std::string line(std::string_view label, const std::vector<std::string>& cells,
                 std::size_t columns) {
  std::string text = fmt::format("| {} |", label);
  for (std::size_t i = 0; i < columns; ++i)
    text += fmt::format(" {} |", i < cells.size() ? markdown_text(cells[i]) : "");
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
  std::string text = fmt::format("### {}\n\nOf: {}\n\n{}{}\n", markdown_text(data.title),
                                 markdown_text(shown_subject(data)),
                                 line(markdown_text(data.row_header), headers, columns), rule);
  for (const WordGrid::Line& row : grid.lines) {
    const std::string label = markdown_text(row.label);
    text += line(row.heading ? fmt::format("**{}**", label) : label, row.cells, columns);
  }
  for (const std::string& note : data.notes) text += fmt::format("\n{}\n", markdown_text(note));
  return text;
}

std::string write(const std::vector<TableData>& tables) {
  return write_each(tables, "\n", write_table);
}

}  // namespace

extern const Format f_markdown{"markdown", "tables of GitHub's Markdown", "md", write};

}  // namespace lanescope
