// SPDX-License-Identifier: MIT
#include "analysis/html/over_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/html/markup.h"
#include "analysis/html/spec.h"
#include "analysis/tables/means.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// The values of a setting, without their names.
std::string shown_values(const Setting& setting) {
  std::vector<std::string> values;
  for (const auto& [_, value] : setting.group->setting.all()) values.push_back(value_text(value));
  return fmt::format("{}", fmt::join(values, ", "));
}

std::vector<std::pair<const Setting*, double>> costs(const std::vector<Setting>& settings,
                                                     const Series& series, int width) {
  std::vector<std::pair<const Setting*, double>> list;
  for (const Setting& setting : settings)
    if (const auto each = mean_instructions(setting.view, series, width))
      list.emplace_back(&setting, *each);
  return list;
}

std::vector<Series> series_of_all(const std::vector<Setting>& settings) {
  std::vector<Series> all;
  for (const Setting& setting : settings)
    for (const Series& series : series_of(setting.group->report))
      if (std::find(all.begin(), all.end(), series) == all.end()) all.push_back(series);
  return all;
}

std::vector<int> widths_of_all(const std::vector<Setting>& settings) {
  std::set<int> all;
  for (const Setting& setting : settings)
    for (const int width : widths_of(setting.group->report)) all.insert(width);
  return few_widths({all.begin(), all.end()});
}

std::string cheapest_cell(const std::vector<Setting>& settings, const Series& series, int width) {
  const auto list = costs(settings, series, width);
  if (list.empty()) return "<td>–</td>";
  const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto& [best, fewest] = *std::min_element(list.begin(), list.end(), less);
  const double most = std::max_element(list.begin(), list.end(), less)->second;
  if (most == fewest) return fmt::format("<td>{:.2f} at all</td>", fewest);
  return fmt::format("<td><b>{:.2f}</b> at {}<br><span class=\"of\">up to {:.2f}</span></td>",
                     fewest, html_escaped(shown_values(*best)), most);
}

/// The least distance of an axis of numbers that needs a logarithm: samples a pixel do, thresholds
/// do not.
constexpr double kManyTimes = 8.0;

Json parameter_axis(const SettingAxis& axis) {
  Json x{{"field", "value"}, {"title", axis.parameter}};
  Json values = Json::array();
  if (!is_numeric(axis)) {
    for (const Value& value : axis.values) values.push_back(value_text(value));
    x.update({{"type", "ordinal"}, {"sort", values}, {"axis", {{"labelAngle", 0}}}});
    return x;
  }
  for (const Value& value : axis.values) values.push_back(*number(value));
  const double first = values.front(), last = values.back();
  x["type"] = "quantitative";
  if (first > 0.0 && last / first >= kManyTimes)
    x["scale"] = {{"type", "log"}, {"nice", false}, {"padding", 8}};
  else
    x["scale"] = {{"zero", false}, {"nice", false}, {"padding", 8}};
  x["axis"] = {{"values", values},
               {"format", ".3~g"},
               {"grid", false},
               {"labelOverlap", "greedy"},
               {"labelSeparation", 5}};
  return x;
}

constexpr const char* kAll = "All stages";

/// The rows of a parameter's charts: a figure of each stage, and of all together.
class OverRows {
 public:
  OverRows(const std::vector<Setting>& settings, const SettingAxis& axis, DataColumn figure)
      : settings_(settings), axis_(axis) {
    std::vector<DataColumn> columns{
        {"value", axis.parameter, ""}, {"stage", "Stage", ""}, std::move(figure)};
    for (const SettingAxis& other : axes_of(settings))
      if (other.parameter != axis.parameter) others_.push_back(other.parameter);
    for (const std::string& other : others_) columns.push_back({other, other, ""});
    frame_ = DataFrame(series_columns(std::move(columns)));
  }

  /// `figure(view, series, width, stage)` of each stage; an empty stage is all together.
  template <class Figure>
  DataFrame take(const Figure& figure) {
    for (const Setting& setting : settings_) {
      if (!setting.group->setting.contains(axis_.parameter)) continue;
      for (const Series& series : series_of(setting.group->report))
        for (const int width : setting.view.widths(series)) {
          std::vector<std::string> stages{""};
          for (std::string& stage : stages_of(setting.group->report))
            stages.push_back(std::move(stage));
          for (const std::string& stage : stages)
            if (const std::optional<double> value = figure(setting.view, series, width, stage))
              add(setting, series, width, stage, *value);
        }
    }
    return std::move(frame_);
  }

  std::vector<Pick> picks() const {
    std::vector<Pick> list{{"stage", kAll}, {"facet", nullptr}};
    const Setting& first = settings_[first_setting(settings_)];
    for (const std::string& other : others_) list.push_back({other, shown_value(first, other)});
    return list;
  }

 private:
  void add(const Setting& setting, const Series& series, int width, const std::string& stage,
           double value) {
    const Value& at = setting.group->setting[axis_.parameter];
    std::vector<Json> row{shown_kernel(series.kernel),
                          shown_facet(series),
                          width,
                          is_numeric(axis_) ? Json(*number(at)) : Json(value_text(at)),
                          stage.empty() ? kAll : stage,
                          value};
    for (const std::string& other : others_) row.push_back(shown_value(setting, other));
    frame_.add(std::move(row));
  }

  const std::vector<Setting>& settings_;
  const SettingAxis& axis_;
  std::vector<std::string> others_;
  DataFrame frame_;
};

Chart instructions_chart(const std::vector<Setting>& settings, const SettingAxis& axis) {
  constexpr std::string_view kSpec = R"json({
    "transform": [{"calculate": "'W = ' + datum.lanes", "as": "machine"}],
    "facet": {"field": "machine", "title": null, "sort": {"field": "lanes"}},
    "columns": 4,
    "resolve": {"scale": {"y": "independent"}},
    "spec": {
      "width": 185, "height": 170,
      "encoding": {
        "x": null,
        "y": {"field": "figure", "type": "quantitative", "scale": {"zero": false}}},
      "layer": [
        {"mark": {"type": "line", "stroke": "currentColor", "point": "@ink_point"},
         "encoding": {
           "strokeDash": {"field": "kernel", "title": "Kernel", "sort": null},
           "shape": {"field": "kernel", "title": "Kernel", "sort": null}}},
        {"transform": [
           {"joinaggregate": [{"op": "min", "field": "figure", "as": "least"},
                              {"op": "min", "field": "value", "as": "begin"},
                              {"op": "max", "field": "value", "as": "end"}],
            "groupby": ["kernel", "lanes"]},
           {"calculate": "datum.figure == datum.least ? datum.value : datum.end", "as": "low"},
           {"joinaggregate": [{"op": "min", "field": "low", "as": "at"}],
            "groupby": ["kernel", "lanes"]},
           {"calculate": "datum.value == datum.at && datum.at != datum.begin && datum.at != datum.end ? format(datum.figure, '.2f') : ''",
            "as": "label"}],
         "mark": {"type": "text", "dy": 12, "fontWeight": "bold", "fill": "currentColor"},
         "encoding": {"text": {"field": "label"}}}]}
  })json";
  const Report& report = settings.front().group->report;
  const ElementWords element = element_of(report);
  OverRows rows(settings, axis, {"figure", "Instructions/" + element.abbreviation, ".3f"});
  auto spec = spec_from(kSpec, report);
  spec["spec"]["encoding"]["x"] = parameter_axis(axis);
  spec["spec"]["encoding"]["y"]["title"] = "Instructions per " + element.name;
  Chart chart{
      "instructions",
      fmt::format(
          "Instructions for each {} over {}, {}; the least of each line is written "
          "at its point unless that is one of its ends. Scales differ, and do not begin at 0.",
          element.name, axis.parameter, settings.front().view.caption()),
      std::move(spec),
      {},
      rows.picks()};
  chart.rows = rows.take(
      [](const ReportView& view, const Series& series, int width, const std::string& stage) {
        return stage.empty() ? mean_instructions(view, series, width)
                             : mean_stage_instructions(view, series, stage, width);
      });
  return chart;
}

Chart utilization_over(const std::vector<Setting>& settings, const SettingAxis& axis) {
  constexpr std::string_view kSpec = R"json({
    "facet": {"field": "kernel", "title": null, "sort": "@kernels"},
    "columns": 2,
    "spec": {
      "width": 330, "height": 230,
      "mark": {"type": "line", "point": {"size": 40}},
      "encoding": {
        "x": null,
        "y": {"field": "figure", "type": "quantitative", "title": "Utilization",
              "scale": {"zero": false}, "axis": {"format": "%"}},
        "color": {"field": "lanes", "type": "ordinal", "title": "W (lanes)",
                  "scale": {"scheme": {"name": "viridis", "extent": [0.15, 0.8]}}}}}
  })json";
  const Report& report = settings.front().group->report;
  OverRows rows(settings, axis, {"figure", "Utilization", ".1%"});
  auto spec = spec_from(kSpec, report);
  spec["spec"]["encoding"]["x"] = parameter_axis(axis);
  Chart chart{"utilization",
              fmt::format("Utilization over {} and W, {}; the scale does not begin at 0.",
                          axis.parameter, settings.front().view.caption()),
              std::move(spec),
              {},
              rows.picks()};
  chart.rows = rows.take(
      [](const ReportView& view, const Series& series, int width, const std::string& stage) {
        return stage.empty() ? mean_utilization(view, series, width)
                             : mean_stage_utilization(view, series, stage, width);
      });
  return chart;
}

}  // namespace

Markup cheapest_settings(const std::vector<Setting>& settings) {
  if (settings.size() < 2) return {};
  const std::vector<int> widths = widths_of_all(settings);
  std::vector<std::string> names;
  for (const SettingAxis& axis : axes_of(settings)) names.push_back(axis.parameter);
  std::string rows;
  for (const Series& series : series_of_all(settings)) {
    std::string row = fmt::format("<tr><th scope=\"row\">{}</th>", html_escaped(shown(series)));
    for (const int width : widths) row += cheapest_cell(settings, series, width);
    if (row.find("<b>") != row.npos) rows += row + "</tr>\n";
  }
  if (rows.empty()) return {};
  std::string head;
  for (const int width : widths) head += fmt::format("<th scope=\"col\">W = {}</th>", width);
  return {
      fmt::format("<div class=\"scroll\" tabindex=\"0\"><table class=\"answer\">\n"
                  "<caption>Of all settings, the fewest instructions for each {}, and at which {} "
                  "<span class=\"of\">All stages; {}</span></caption>\n"
                  "<thead><tr><th scope=\"col\">Kernel</th>{}</tr></thead>\n<tbody>\n{}</tbody>\n"
                  "</table></div>\n",
                  html_escaped(element_of(settings.front().group->report).name),
                  html_escaped(fmt::format("{}", fmt::join(names, ", "))),
                  html_escaped(settings.front().view.caption()), head, rows)};
}

std::vector<SectionBlock> over_parameter(const std::vector<Setting>& settings,
                                         const SettingAxis& axis) {
  return {instructions_chart(settings, axis), utilization_over(settings, axis)};
}

}  // namespace lanescope
