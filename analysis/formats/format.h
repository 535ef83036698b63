// SPDX-License-Identifier: MIT
// The contract of a format: how tables become a document.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/tables/table.h"

namespace lanescope {

/// The descriptor; analysis/formats/<name>.cpp ends in one, and the registry lists them.
struct Format {
  std::string_view name;
  std::string_view summary;
  std::string_view extension;  ///< Of files, without the dot.
  std::string (*write)(const std::vector<TableData>& tables);
};

/// Every format, in the order of analysis/formats/CMakeLists.txt.
const std::vector<const Format*>& formats();

/// Requires that there is a format of that name.
const Format& find_format(std::string_view name);

/// One document of all tables: each written by `write_table`, with `gap` between them.
std::string write_each(const std::vector<TableData>& tables, std::string_view gap,
                       std::string (*write_table)(const TableData& data));

/// A table as rows of words, for formats that are grids of words: each column becomes one of ours
/// and, where a paper has a number in it, one of the paper's and, where the two are
/// comparable, one of the difference.
struct WordGrid {
  struct Column {
    std::string header;
    bool starts_group;   ///< The first of the columns that one column of the table became.
    bool words = false;  ///< Holds words, which read better on the left than on the right.
  };
  struct Line {
    std::string label;
    bool heading;  ///< Over the rows below; has no cells.
    std::vector<std::string> cells;
  };
  std::vector<Column> columns;
  std::vector<Line> lines;
};
WordGrid word_grid(const TableData& data);

}  // namespace lanescope
