// SPDX-License-Identifier: MIT
#include "analysis/html/spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "analysis/pictures/palette.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// More widths than this leave no room for a label or a point at each.
constexpr std::size_t kMostLabelled = 12;
/// The facet, as tables and choices call it.
constexpr const char* kWork = "Work";

bool are_many(const std::vector<int>& widths) { return widths.size() > kMostLabelled; }

/// Appends what the list does not have.
void add(std::vector<std::string>& list, const std::string& name) {
  if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

Json stage_encoding(const Report& report) {
  Json range = Json::array();
  const std::vector<std::string> stages = stages_of(report);
  for (const std::string& stage : stages) range.push_back(colour_text(stage_colour(stage)));
  return {{"field", "stage"},
          {"type", "nominal"},
          {"title", "Stage"},
          {"scale", {{"domain", stages}, {"range", std::move(range)}}}};
}

/// The widths that an axis labels: all; of many the narrowest and some `most` multiples of a power
/// of two.
std::vector<int> labelled(const std::vector<int>& widths, int most) {
  if (!are_many(widths)) return widths;
  int step = 1;
  while ((widths.back() - widths.front()) / step > most) step *= 2;
  std::vector<int> labels{widths.front()};
  for (int width = (widths.front() / step + 1) * step; width <= widths.back(); width += step)
    labels.push_back(width);
  return labels;
}

/// Few widths are powers of two in the main; all of a range are seen best at equal distances.
Json lanes_scale(const std::vector<int>& widths) {
  if (are_many(widths))
    return {{"nice", false}, {"zero", false}, {"domain", {widths.front() - 1, widths.back() + 1}}};
  constexpr double kMargin = 1.19;  // A quarter of an octave.
  return {{"type", "log"},
          {"base", 2},
          {"nice", false},
          {"domain", {widths.front() / kMargin, widths.back() * kMargin}}};
}

Json lanes_axis(const Report& report) {
  const std::vector<int> widths = machine_widths_of(report);
  return {{"field", "lanes"},
          {"type", "quantitative"},
          {"title", "W (lanes)"},
          {"scale", lanes_scale(widths)},
          {"axis", {{"values", labelled(widths, 8)}, {"format", "d"}, {"grid", false}}}};
}

Json bars_axis(const Report& report) {
  return {{"field", "lanes"},
          {"type", "ordinal"},
          {"title", "W (lanes)"},
          {"axis", {{"labelAngle", 0}, {"values", labelled(machine_widths_of(report), 4)}}}};
}

Json points(const Report& report) {
  if (are_many(machine_widths_of(report))) return false;
  return {{"size", 40}};
}

void fill_in(Json& spec, const Report& report) {
  if (spec == "@stage") {
    spec = stage_encoding(report);
  } else if (spec == "@lanes") {
    spec = lanes_axis(report);
  } else if (spec == "@W") {
    spec = bars_axis(report);
  } else if (spec == "@point") {
    spec = points(report);
  } else if (spec == "@ink_point") {
    spec = points(report);
    if (spec.is_object()) spec.update({{"fill", "currentColor"}, {"stroke", nullptr}});
  } else if (spec == "@stages") {
    spec = stages_of(report);
  } else if (spec == "@kernels") {
    spec = kernels_of(report);
  } else if (spec == "@facets") {
    spec = facets_of(report);
  } else if (spec == "@scenes") {
    spec = scenes_of(report);
  } else if (spec.is_structured()) {
    for (Json& part : spec) fill_in(part, report);
  }
}

/// `wanted` if it is among the options, else the first of them.
template <class T>
T first_or(const std::vector<T>& options, const T& wanted) {
  const bool there = std::find(options.begin(), options.end(), wanted) != options.end();
  return there ? wanted : options.front();
}

}  // namespace

std::vector<std::string> stages_of(const Report& report) {
  std::vector<std::string> occurring;
  for (const RunRecord& run : report.runs)
    for (const StageRecord& stage : run.stages) add(occurring, stage.name);
  const auto& known = known_stages();
  const auto place = [&](const std::string& stage) {
    return std::find(known.begin(), known.end(), stage);
  };
  std::stable_sort(occurring.begin(), occurring.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return occurring;
}

std::vector<std::string> kernels_of(const Report& report) {
  std::vector<std::string> kernels;
  for (const Series& series : series_of(report)) add(kernels, shown_kernel(series.kernel));
  return kernels;
}

std::vector<std::string> facets_of(const Report& report) {
  std::vector<std::string> facets;
  for (const Series& series : series_of(report)) add(facets, shown_facet(series));
  return facets;
}

std::string shown_scenes(const ReportView& view) {
  return fmt::format("{}", fmt::join(view.scenes(), ", "));
}

ElementWords element_of(const Report& report) {
  std::vector<std::string> names;
  for (const RunRecord& run : report.runs) add(names, run.element.name);
  if (names.size() != 1) return {"element", "element"};
  return {names.front(), report.runs.front().element.abbreviation};
}

std::vector<int> few_widths(const std::vector<int>& widths) {
  if (!are_many(widths)) return widths;
  std::vector<int> few;
  for (const int width : widths)
    if (std::has_single_bit(static_cast<unsigned>(width))) few.push_back(width);
  return few;
}

std::vector<DataColumn> series_columns(std::vector<DataColumn> others) {
  std::vector<DataColumn> columns{
      {"kernel", "Kernel", ""}, {"facet", kWork, ""}, {"lanes", "W", ""}};
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

Json spec_from(std::string_view text, const Report& report) {
  Json spec = Json::parse(text);
  fill_in(spec, report);
  return spec;
}

Json panel_for(Json panel, std::string_view field, const std::string& value) {
  Json transforms = Json::array();
  transforms.push_back({{"filter", {{"field", field}, {"equal", value}}}});
  if (panel.contains("transform"))
    for (Json& transform : panel["transform"]) transforms.push_back(transform);
  panel["transform"] = std::move(transforms);
  panel["title"] = value;
  return panel;
}

Pick pick_of_lanes(const Report& report) {
  const std::vector<int> widths = machine_widths_of(report);
  return {"lanes", first_or(widths, Configuration{}.width)};
}

Pick pick_of_facet() { return {"facet", nullptr}; }
Pick pick_of_kernel() { return {"kernel", nullptr}; }

}  // namespace lanescope
