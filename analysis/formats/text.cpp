// SPDX-License-Identifier: MIT
// Aligned columns for a terminal.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/formats/format.h"

namespace lanescope {
namespace {

constexpr std::size_t kNoteWidth = 100;

std::vector<std::size_t> column_widths(const WordGrid& grid) {
  std::vector<std::size_t> widths;
  for (const WordGrid::Column& column : grid.columns) widths.push_back(column.header.size());
  for (const WordGrid::Line& line : grid.lines)
    for (std::size_t i = 0; i < line.cells.size(); ++i)
      widths[i] = std::max(widths[i], line.cells[i].size());
  return widths;
}

std::size_t label_width(const TableData& data, const WordGrid& grid) {
  std::size_t width = data.row_header.size();
  for (const WordGrid::Line& line : grid.lines)
    if (!line.heading) width = std::max(width, line.label.size());
  return width;
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

/// `text` in lines of at most kNoteWidth, broken at spaces.
std::string wrapped(std::string_view text) {
  std::string lines;
  while (text.size() > kNoteWidth) {
    const std::size_t end = text.rfind(' ', kNoteWidth);
    if (end == text.npos) break;
    lines += fmt::format("{}\n", text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines + fmt::format("{}\n", text);
}

class TextTable {
 public:
  explicit TextTable(const TableData& data)
      : data_(data),
        grid_(word_grid(data)),
        widths_(column_widths(grid_)),
        label_width_(label_width(data, grid_)) {}

  std::string write() const {
    std::vector<std::string> headers;
    for (const WordGrid::Column& column : grid_.columns) headers.push_back(column.header);
    const std::string header = line(data_.row_header, headers);
    std::string text = fmt::format("{}\nOf: {}\n\n{}", data_.title, shown_subject(data_), header);
    text += std::string(header.size() - 1, '-') + '\n';
    for (const WordGrid::Line& row : grid_.lines)
      text += row.heading ? row.label + '\n' : line(row.label, row.cells);
    for (const std::string& note : data_.notes) text += '\n' + wrapped(note);
    return text;
  }

 private:
  std::string line(const std::string& label, const std::vector<std::string>& cells) const {
    std::string text = fmt::format("{:<{}}", label, label_width_);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const WordGrid::Column& column = grid_.columns[i];
      text += column.starts_group ? "  " : " ";
      text += column.words ? fmt::format("{:<{}}", cells[i], widths_[i])
                           : fmt::format("{:>{}}", cells[i], widths_[i]);
    }
    return trimmed(text);
  }

  const TableData& data_;
  WordGrid grid_;
  std::vector<std::size_t> widths_;
  std::size_t label_width_;
};

std::string write(const std::vector<TableData>& tables) {
  return write_each(tables, "\n\n", [](const TableData& data) { return TextTable(data).write(); });
}

}  // namespace

extern const Format f_text{"text", "aligned columns for a terminal", "txt", write};

}  // namespace lanescope
