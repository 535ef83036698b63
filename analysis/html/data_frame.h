// SPDX-License-Identifier: MIT
// Rows of figures with named columns: what a chart draws and what the table beside it shows.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lanescope {

/// A column: its key in a chart's specification, its heading, and how the table shows its numbers
/// (`.1%`, `.2f`; empty for words and counts).
struct DataColumn {
  std::string name;
  std::string title;
  std::string format;

  bool operator==(const DataColumn&) const = default;
};

class DataFrame {
 public:
  using Json = nlohmann::ordered_json;

  DataFrame() = default;
  explicit DataFrame(std::vector<DataColumn> columns);

  /// Requires a value for each column: words, a number, or null. Numbers keep five digits.
  void add(std::vector<Json> row);
  /// The rows of another frame with the same columns, behind its own.
  void append(const DataFrame& other);

  bool operator==(const DataFrame&) const = default;

  bool empty() const { return rows_.empty(); }
  const std::vector<DataColumn>& columns() const { return columns_; }
  const std::vector<std::vector<Json>>& rows() const { return rows_; }

  /// By columns, which is a tenth of the size of a list of objects: words as places in a list of
  /// different words, numbers as they are.
  Json to_json() const;

 private:
  std::vector<DataColumn> columns_;
  std::vector<std::vector<Json>> rows_;
};

}  // namespace lanescope
