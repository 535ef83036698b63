// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/studies/luong/study.h"
#include "analysis/tables/table.h"

namespace lanescope::luong {
namespace {

/// The difference as the map colours it: utilizations and shares in points, everything else in
/// percent of the thesis's figure.
std::optional<double> difference(const Figure& figure) {
  if (!has_difference(figure)) return {};
  if (figure.unit == &kPercent) return rounded_difference(figure);
  if (figure.unit == &kShare) return *rounded_difference(figure) * 100.0;
  if (*figure.paper == 0.0) return {};
  return 100.0 * (*figure.ours / *figure.paper - 1.0);
}

std::string_view measured_in(const Figure& figure) {
  return figure.unit == &kPercent || figure.unit == &kShare ? "points" : "%";
}

/// `Table 4.1: LOCKSTEP, triangles` of a title that goes on after another colon.
std::string short_title(const std::string& title) {
  const std::size_t colon = title.find(':');
  const std::size_t second = title.find(':', colon == title.npos ? colon : colon + 1);
  return title.substr(0, second);
}

class Rows {
 public:
  void add_table(const TableData& table) {
    std::string heading;
    for (const Row& row : table.rows) {
      if (row.cells.empty()) heading = row.label.substr(0, row.label.find(':')) + ", ";
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        add_cell(table, heading + row.label, i, row.cells[i]);
    }
  }
  DataFrame take() { return std::move(frame_); }

 private:
  void add_cell(const TableData& table, const std::string& label, std::size_t column,
                const Cell& cell) {
    if (!table.columns[column].starts_with("W = ")) return;
    if (cell.figure) add(table, label, column, *cell.figure);
    if (cell.share) add(table, label + ", share", column, *cell.share);
  }

  void add(const TableData& table, const std::string& label, std::size_t column,
           const Figure& figure) {
    const auto value = difference(figure);
    if (!value) return;
    frame_.add({short_title(table.title), label, table.columns[column], shown(figure),
                shown_paper(figure), *value, measured_in(figure)});
  }

  DataFrame frame_{{{"table", "Table", ""},
                    {"row", "Row", ""},
                    {"column", "W", ""},
                    {"ours", "Ours", ""},
                    {"thesis", "Thesis", ""},
                    {"difference", "Difference", "+.1f"},
                    {"unit", "In", ""}}};
};

/// Differences up to here have half of the colours: most are.
constexpr double kNear = 10.0;

/// The largest difference either way, for the ends of the colours.
double largest(const DataFrame& rows) {
  double most = 5.0 * kNear;
  for (const auto& row : rows.rows()) {
    const auto& difference = row[row.size() - 2];
    if (difference.is_number()) most = std::max(most, std::abs(difference.get<double>()));
  }
  return most;
}

/// A panel for each table that has a row, in the order of the rows.
nlohmann::ordered_json spec(const Report& report, const DataFrame& rows) {
  constexpr std::string_view kPanel = R"json({
    "width": 250, "height": {"step": 20},
    "transform": [
      {"calculate": "format(datum.difference, '+.0f') + (datum.unit == '%' ? '%' : '')",
       "as": "shown"}],
    "encoding": {
      "x": {"field": "column", "type": "ordinal", "title": null, "sort": null,
            "axis": {"labelAngle": 0, "orient": "top"}},
      "y": {"field": "row", "type": "ordinal", "title": null, "sort": null,
            "axis": {"labelLimit": 240}}},
    "layer": [
      {"mark": "rect",
       "encoding": {"color": {
         "field": "difference", "type": "quantitative", "title": "Ours - thesis",
         "scale": {"range": ["#6b3304", "#e8964a", "#f7f7f7", "#7db3de", "#143d66"]}}}},
      {"mark": {"type": "text", "fontSize": 10},
       "encoding": {
         "text": {"field": "shown"},
         "color": {"condition": {"test": "abs(datum.difference) > 25", "value": "#fff"},
                   "value": "#111"}}}]
  })json";
  auto panels = nlohmann::ordered_json::array();
  std::string last;
  const double most = largest(rows);
  for (const auto& row : rows.rows()) {
    const auto table = row.front().get<std::string>();
    if (table != last) {
      auto panel = spec_from(kPanel, report);
      panel["layer"][0]["encoding"]["color"]["scale"]["domain"] = {-most, -kNear, 0.0, kNear, most};
      panels.push_back(panel_for(std::move(panel), "table", table));
    }
    last = table;
  }
  return {{"concat", std::move(panels)}, {"columns", 2}};
}

std::vector<SectionBlock> build(const ReportView& view) {
  Rows gathered;
  for (const Table* table : luong_tables()) gathered.add_table(build_table(*table, view));
  DataFrame rows = gathered.take();
  if (rows.empty()) return {};
  auto panels = spec(view.report(), rows);
  return {Chart{"map",
                "Ours against the thesis, cell by cell: utilizations and shares in points after "
                "rounding as the thesis rounds, other figures in percent of the thesis's; " +
                    view.caption() + ". Blue: ours is larger.",
                std::move(panels), std::move(rows)}};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_against_thesis{
    "against-thesis", "Against the thesis",
    "Each figure that the thesis prints for a width, and how far ours is from it.", luong::build};

}  // namespace lanescope
