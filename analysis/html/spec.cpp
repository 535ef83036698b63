// SPDX-License-Identifier: MIT
#include "analysis/html/spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "analysis/pictures/palette.h"
#include "analysis/tables/thesis.h"
#include "analysis/tables/thesis_figures.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

Json stage_encoding(const Report& report) {
  Json range = Json::array();
  const std::vector<std::string> stages = stages_of(report);
  for (std::size_t place = 0; place < stages.size(); ++place)
    range.push_back(colour_text(stage_colour(stages[place], place)));
  return {{"field", "stage"},
          {"type", "nominal"},
          {"title", "Stage"},
          {"scale", {{"domain", stages}, {"range", std::move(range)}}}};
}

Json lanes_axis(const Report& report) {
  constexpr double kMargin = 1.19;  // A quarter of an octave.
  const std::vector<int> widths = widths_of(report);
  return {{"field", "lanes"},
          {"type", "quantitative"},
          {"title", "W (lanes)"},
          {"scale",
           {{"type", "log"},
            {"base", 2},
            {"nice", false},
            {"domain", {widths.front() / kMargin, widths.back() * kMargin}}}},
          {"axis", {{"values", widths}, {"format", "d"}, {"grid", false}}}};
}

void fill_in(Json& spec, const Report& report) {
  if (spec == "@stage") {
    spec = stage_encoding(report);
  } else if (spec == "@lanes") {
    spec = lanes_axis(report);
  } else if (spec == "@stages") {
    spec = stages_of(report);
  } else if (spec == "@kernels") {
    spec = kernels_of(report);
  } else if (spec == "@scenes") {
    spec = scenes_of(report);
  } else if (spec.is_structured()) {
    for (Json& part : spec) fill_in(part, report);
  }
}

template <class Values>
auto first_or(const Values& values, const typename Values::value_type& wanted) {
  return std::find(values.begin(), values.end(), wanted) != values.end() ? wanted : values.front();
}

}  // namespace

std::vector<Series> series_of(const Report& report) {
  std::vector<std::string_view> kernels;
  std::set<std::pair<std::string_view, Micropolygon>> present;
  for (const RunRecord& run : report.runs) {
    const Configuration& c = run.configuration;
    if (std::find(kernels.begin(), kernels.end(), c.kernel) == kernels.end())
      kernels.emplace_back(c.kernel);
    present.emplace(c.kernel, c.shape());
  }
  std::vector<Series> series;
  for (const std::string_view kernel : kernels)
    for (const Micropolygon shape : {Micropolygon::kTriangle, Micropolygon::kQuad})
      if (present.contains({kernel, shape})) series.push_back({kernel, shape});
  return series;
}

std::vector<std::string> stages_of(const Report& report) {
  std::vector<std::string> occurring;
  for (const RunRecord& run : report.runs)
    for (const StageRecord& stage : run.stages)
      if (std::find(occurring.begin(), occurring.end(), stage.name) == occurring.end())
        occurring.push_back(stage.name);
  const std::span<const std::string_view> coloured = coloured_stages();
  const auto place = [&](const std::string& stage) {
    return std::find(coloured.begin(), coloured.end(), stage);
  };
  std::stable_sort(occurring.begin(), occurring.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return occurring;
}

std::vector<int> widths_of(const Report& report) {
  std::set<int> widths;
  for (const RunRecord& run : report.runs) widths.insert(run.configuration.width);
  return {widths.begin(), widths.end()};
}

std::string shown_kernel(std::string_view kernel) {
  std::string letters(kernel);
  std::transform(letters.begin(), letters.end(), letters.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return letters;
}

std::vector<std::string> kernels_of(const Report& report) {
  std::vector<std::string> kernels;
  for (const Series& series : series_of(report))
    if (const std::string kernel = shown_kernel(series.kernel);
        std::find(kernels.begin(), kernels.end(), kernel) == kernels.end())
      kernels.push_back(kernel);
  return kernels;
}

std::string shown_scenes(const ReportView& view) {
  return fmt::format("{}", fmt::join(view.scenes(), ", "));
}

std::string shown_shape(Micropolygon shape) { return fmt::format("{}s", to_string(shape)); }

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::vector<DataColumn> series_columns(std::vector<DataColumn> others) {
  std::vector<DataColumn> columns{
      {"kernel", "Kernel", ""}, {"micropolygon", "Micropolygons", ""}, {"lanes", "W", ""}};
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

Json choice(std::string_view name, std::string_view label, const Json& options, const Json& first) {
  return {
      {"name", name},
      {"value", first},
      {"bind", {{"input", "select"}, {"options", options}, {"name", fmt::format("{} ", label)}}}};
}

Json choice_of_lanes(const Report& report) {
  const std::vector<int> widths = widths_of(report);
  return choice("pick_lanes", "W", widths, first_or(widths, kClaimWidth));
}

Json choice_of_shape(const Report& report) {
  std::vector<std::string> shapes;
  for (const Series& series : series_of(report))
    if (const std::string shape = shown_shape(series.shape);
        std::find(shapes.begin(), shapes.end(), shape) == shapes.end())
      shapes.push_back(shape);
  return choice("pick_shape", "Micropolygons", shapes, first_or(shapes, std::string("triangles")));
}

Json choice_of_kernel(const Report& report) {
  const std::vector<std::string> kernels = kernels_of(report);
  return choice("pick_kernel", "Kernel", kernels, kernels.front());
}

}  // namespace lanescope
