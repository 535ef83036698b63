// SPDX-License-Identifier: MIT
// Plain tabular environments that need no package.
#include <fmt/format.h>

#include "analysis/formats/format.h"

namespace lanescope {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      result += fmt::format("\\{}{{}}", c);
    } else {
      if (std::string_view("%&_#${}").find(c) != std::string_view::npos) result += '\\';
      result += c;
    }
  }
  return result;
}

std::string line(std::string_view label, const std::vector<std::string>& cells) {
  std::string text = escaped(label);
  for (const std::string& cell : cells) text += " & " + escaped(cell);
  return text + " \\\\\n";
}

std::string write_table(const TableData& data) {
  const WordGrid grid = word_grid(data);
  std::string alignment = "l";
  std::vector<std::string> headers;
  for (const WordGrid::Column& column : grid.columns) {
    alignment += column.words ? 'l' : 'r';
    headers.push_back(column.header);
  }
  std::string text = fmt::format("% {}\n% Of: {}\n\\begin{{tabular}}{{{}}}\n\\hline\n", data.title,
                                 shown_subject(data), alignment);
  text += line(data.row_header, headers) + "\\hline\n";
  for (const WordGrid::Line& row : grid.lines)
    text += row.heading ? fmt::format("\\multicolumn{{{}}}{{l}}{{\\textit{{{}}}}} \\\\\n",
                                      grid.columns.size() + 1, escaped(row.label))
                        : line(row.label, row.cells);
  text += "\\hline\n\\end{tabular}\n";
  for (const std::string& note : data.notes) text += fmt::format("% {}\n", note);
  return text;
}

std::string write(const std::vector<TableData>& tables) {
  return write_each(tables, "\n", write_table);
}

}  // namespace

extern const Format f_latex{"latex", "plain tabular environments", "tex", write};

}  // namespace lanescope
