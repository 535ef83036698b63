// SPDX-License-Identifier: MIT
#include "analysis/html/table_html.h"

#include <fmt/format.h>

#include "analysis/formats/format.h"
#include "analysis/html/markup.h"

namespace lanescope {
namespace {

/// The class attribute of a column's cells, or of its heading.
std::string class_of(const WordGrid::Column& column, bool heading) {
  if (column.words) return " class=\"words\"";
  return heading && column.starts_group ? " class=\"group\"" : "";
}

std::string header_row(const TableData& data, const WordGrid& grid) {
  std::string text = fmt::format("<tr><th scope=\"col\">{}</th>", html_escaped(data.row_header));
  for (const WordGrid::Column& column : grid.columns)
    text += fmt::format("<th scope=\"col\"{}>{}</th>", class_of(column, true),
                        html_escaped(column.header));
  return text + "</tr>\n";
}

std::string body_row(const WordGrid& grid, const WordGrid::Line& line) {
  const std::string label = html_escaped(line.label);
  if (line.heading)
    return fmt::format("<tr><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                       grid.columns.size() + 1, label);
  std::string text = fmt::format("<tr><th scope=\"row\">{}</th>", label);
  for (std::size_t i = 0; i < grid.columns.size(); ++i)
    text += fmt::format("<td{}>{}</td>", class_of(grid.columns[i], false),
                        i < line.cells.size() ? html_escaped(line.cells[i]) : "");
  return text + "</tr>\n";
}

}  // namespace

std::string table_html(const TableData& data) {
  const WordGrid grid = word_grid(data);
  std::string text = fmt::format(
      "<div class=\"scroll\"><table>\n<caption>{} <span class=\"of\">Of: {}</span></caption>\n"
      "<thead>{}</thead>\n<tbody>\n",
      html_escaped(data.title), html_escaped(shown_subject(data)), header_row(data, grid));
  for (const WordGrid::Line& line : grid.lines) text += body_row(grid, line);
  text += "</tbody>\n</table></div>\n";
  for (const std::string& note : data.notes)
    text += fmt::format("<p class=\"note\">{}</p>\n", html_escaped(note));
  return text;
}

}  // namespace lanescope
