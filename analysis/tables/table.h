// SPDX-License-Identifier: MIT
// The contract of a table: a name, a sentence, and a pure function of a report. Tables are data;
// formats (analysis/formats/format.h) turn them into text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/tables/report_view.h"

namespace lanescope {

/// How a number stands against a paper's.
enum class Difference {
  kAbsolute,  ///< Ours minus theirs.
  kPoints,    ///< The same, of fractions, in hundredths.
  kRelative,  ///< In percent of theirs.
  kBound,     ///< Theirs is an upper bound, so there is none.
};

/// What a number is and how it is shown. A value is stored unscaled: a utilization as 0.83.
struct Unit {
  std::string_view name;    ///< Of the stored value, for CSV.
  double scale;             ///< Shown value over stored value.
  std::string_view suffix;  ///< After the shown value.
  int decimals;
  int paper_decimals;  ///< As the paper prints it; a difference is of numbers rounded so.
  Difference difference;
};

inline constexpr Unit kPercent{"fraction", 100.0, "%", 1, 0, Difference::kAbsolute};
inline constexpr Unit kSmallPercent{"fraction", 100.0, "%", 3, 0, Difference::kBound};
inline constexpr Unit kShare{"fraction", 1.0, "", 2, 2, Difference::kPoints};
inline constexpr Unit kInstructions{"instructions/element", 1.0, "", 2, 2, Difference::kRelative};
inline constexpr Unit kLines{"lines/execution", 1.0, "", 2, 2, Difference::kRelative};
inline constexpr Unit kCount{"count", 1.0, "", 0, 0, Difference::kAbsolute};
inline constexpr Unit kMillions{"count", 1e-6, " M", 2, 2, Difference::kRelative};
inline constexpr Unit kFactor{"factor", 1.0, "x", 2, 1, Difference::kAbsolute};
inline constexpr Unit kPoints{"points", 1.0, "", 2, 2, Difference::kAbsolute};
inline constexpr Unit kMeasure{"ratio", 1.0, "", 4, 4, Difference::kAbsolute};

/// A number of ours, and a paper's where it has one.
struct Figure {
  std::optional<double> ours;
  std::optional<double> paper;
  const Unit* unit = &kCount;
  /// Whether both are of the same thing. If not, the paper's is not shown, and there is no
  /// difference.
  bool comparable = true;
};

/// What stands in place of a paper's number, or of a verdict, that ours is not comparable with.
inline constexpr std::string_view kNotComparable = "not comparable";

/// A place in a table: a figure, with a share in parentheses perhaps; or words; or nothing.
struct Cell {
  std::optional<Figure> figure;
  std::optional<Figure> share;
  std::string words;
};

/// Cells for the columns of the table, or none: the row is then a heading over those below it.
struct Row {
  std::string label;
  std::vector<Cell> cells;
};

struct TableData {
  std::string name;     ///< Of the table's descriptor.
  std::string caption;  ///< What the figures are of: the scenes, as ReportView::caption has them.
  std::string setting;  ///< With what parameters, as ReportView::setting has them.
  std::string title;
  std::string row_header;
  std::vector<std::string> columns;
  std::vector<Row> rows;
  std::vector<std::string> notes;  ///< Sentences that define or qualify, shown below.
};

/// The descriptor; analysis/tables/<name>.cpp ends in one, and the registry lists them. Studies
/// have tables of their own.
struct Table {
  std::string_view name;
  std::string_view summary;
  /// Leaves `name` and `setting` to build_table, and `caption` too unless it is not that of the
  /// view. Without rows if the report has no such figures.
  TableData (*build)(const ReportView& view);
};

/// Every table that any run can have, in the order of analysis/tables/CMakeLists.txt.
const std::vector<const Table*>& tables();

TableData build_table(const Table& table, const ReportView& view);

/// Those that have a figure of ours, or words.
std::vector<TableData> build_tables(const std::vector<const Table*>& tables,
                                    const ReportView& view);

/// The headers of a column for each width: `W = 8`.
std::vector<std::string> width_headers(const std::vector<int>& widths);

/// What the figures of a table are of: its caption and its setting.
std::string shown_subject(const TableData& data);

/// The shown form of a figure's own number: `83.4%`, or `n/a`.
std::string shown(const Figure& figure);
/// The shown form of a whole cell, without the paper's number: `83.4% (0.68)`.
std::string shown(const Cell& cell);
/// The paper's number as the paper prints it, or empty; `<1%` for a bound; kNotComparable.
std::string shown_paper(const Figure& figure);
/// The same of a whole cell: `83% (0.68)`.
std::string shown_paper(const Cell& cell);
/// The difference with its sign, to the last digit that the paper prints, in points, or in percent;
/// empty where there is none.
std::string shown_difference(const Figure& figure);
/// The same of a whole cell: `+1 (-2)`.
std::string shown_difference(const Cell& cell);
/// Whether there are two numbers that can be compared, of which the paper's is no bound.
bool has_difference(const Figure& figure);
/// Ours minus the paper's, both scaled, and rounded as the paper rounds; none without difference.
std::optional<double> rounded_difference(const Figure& figure);

}  // namespace lanescope
