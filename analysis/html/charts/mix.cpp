// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/tables/means.h"

namespace lanescope {
namespace {

constexpr std::size_t kMostMnemonics = 20;

/// The names with the most instructions in all stages together, at most kMostMnemonics of them.
std::vector<std::string> most_issued(
    const std::map<std::string, std::map<std::string, double>>& stages) {
  std::map<std::string, double> sums;
  for (const auto& [_, names] : stages)
    for (const auto& [name, value] : names) sums[name] += value;
  std::vector<std::string> names;
  for (const auto& [name, _] : sums) names.push_back(name);
  std::stable_sort(names.begin(), names.end(),
                   [&](const auto& a, const auto& b) { return sums[a] > sums[b]; });
  names.resize(std::min(names.size(), kMostMnemonics));
  return names;
}

DataFrame rows(const ReportView& view, const std::string& title, const InstructionName& name) {
  const std::string each = "Instructions/" + element_of(view.report()).abbreviation;
  DataFrame frame(
      series_columns({{"name", title, ""}, {"stage", "Stage", ""}, {"instructions", each, ".3f"}}));
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series)) {
      std::map<std::string, std::map<std::string, double>> stages;
      for (const std::string& stage : stages_of(view.report()))
        stages[stage] = mean_mix(view, series, width, stage, name);
      for (const std::string& shown : most_issued(stages))
        for (const std::string& stage : stages_of(view.report()))
          if (const auto found = stages[stage].find(shown); found != stages[stage].end())
            frame.add({shown_kernel(series.kernel), shown_facet(series), width, shown, stage,
                       found->second});
    }
  return frame;
}

nlohmann::ordered_json spec(const ReportView& view) {
  constexpr std::string_view kPanel = R"json({
    "width": 270, "height": {"step": 17},
    "mark": "bar",
    "encoding": {
      "y": {"field": "name", "type": "nominal", "title": null,
            "sort": {"field": "instructions", "op": "sum", "order": "descending"}},
      "x": {"field": "instructions", "type": "quantitative"},
      "color": "@stage"}
  })json";
  const Report& report = view.report();
  auto panels = nlohmann::ordered_json::array();
  for (const std::string& kernel : kernels_of(report)) {
    auto panel = panel_for(spec_from(kPanel, report), "kernel", kernel);
    panel["encoding"]["x"]["title"] = "Instructions per " + element_of(report).name;
    panels.push_back(std::move(panel));
  }
  return {
      {"concat", std::move(panels)}, {"columns", 2}, {"resolve", {{"scale", {{"x", "shared"}}}}}};
}

std::vector<SectionBlock> build(const ReportView& view) {
  const InstructionName mnemonic_of = [](const InstructionRecord& counts) {
    return counts.mnemonic;
  };
  const std::vector<Pick> picks{pick_of_facet(), pick_of_lanes(view.report())};
  return {Chart{"classes", "Instructions by class and stage, " + view.caption() + ".", spec(view),
                rows(view, "Class", class_in(view.report())), picks},
          Chart{"mnemonics",
                "The 20 instructions that are issued most, by stage, " + view.caption() + ".",
                spec(view), rows(view, "Instruction", mnemonic_of), picks}};
}

}  // namespace

extern const Section s_mix{"mix", "Instruction mix", "What is issued for each element of the work.",
                           build};

}  // namespace lanescope
