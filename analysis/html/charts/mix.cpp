// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/report/figures.h"

namespace lanescope {
namespace {

constexpr std::size_t kMostMnemonics = 20;

/// What instructions are gathered by: their class, or their mnemonic.
using Name = std::function<std::string(const InstructionRecord&)>;

/// Instructions for each micropolygon by name, of one stage at one width.
std::map<std::string, double> by_name(const ReportView& view, const Series& series, int width,
                                      const std::string& stage, const Name& name) {
  std::map<std::string, double> means;
  for (const std::string& scene : view.scenes()) {
    const RunRecord* run = view.find(series, scene, width);
    const StageRecord* found = run ? run->stage(stage) : nullptr;
    const auto rasterized = run ? run->counter("micropolygons_rasterized") : std::nullopt;
    if (!found || !rasterized) continue;
    for (const InstructionRecord& counts : found->instructions)
      means[name(counts)] += Ratio{counts.issued, *rasterized}.value().value_or(0.0) /
                             static_cast<double>(view.scenes().size());
  }
  return means;
}

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

DataFrame rows(const ReportView& view, const std::string& title, const Name& name) {
  DataFrame frame(series_columns(
      {{"name", title, ""}, {"stage", "Stage", ""}, {"instructions", "Instructions/mp", ".3f"}}));
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series)) {
      std::map<std::string, std::map<std::string, double>> stages;
      for (const std::string& stage : stages_of(view.report()))
        stages[stage] = by_name(view, series, width, stage, name);
      for (const std::string& shown : most_issued(stages))
        for (const std::string& stage : stages_of(view.report()))
          if (const auto found = stages[stage].find(shown); found != stages[stage].end())
            frame.add({shown_kernel(series.kernel), shown_shape(series.shape), width, shown, stage,
                       found->second});
    }
  return frame;
}

nlohmann::ordered_json spec(const ReportView& view) {
  constexpr std::string_view kPanel = R"json({
    "transform": [{"filter": "datum.micropolygon == pick_shape && datum.lanes == pick_lanes"}],
    "width": 270, "height": {"step": 17},
    "mark": "bar",
    "encoding": {
      "y": {"field": "name", "type": "nominal", "title": null,
            "sort": {"field": "instructions", "op": "sum", "order": "descending"}},
      "x": {"field": "instructions", "type": "quantitative",
            "title": "Instructions per micropolygon"},
      "color": "@stage"}
  })json";
  const Report& report = view.report();
  auto panels = nlohmann::ordered_json::array();
  for (const std::string& kernel : kernels_of(report))
    panels.push_back(panel_for(spec_from(kPanel, report), "kernel", kernel));
  return {{"params", {choice_of_shape(report), choice_of_lanes(report)}},
          {"concat", std::move(panels)},
          {"columns", 2}};
}

std::vector<Block> build(const ReportView& view) {
  std::map<std::string, std::string> classes;
  for (const InstructionEntry& entry : view.report().instructions)
    classes[entry.mnemonic] = entry.instruction_class;
  const Name class_of = [&](const InstructionRecord& counts) { return classes[counts.mnemonic]; };
  const Name mnemonic_of = [](const InstructionRecord& counts) { return counts.mnemonic; };
  return {Chart{"classes", "Instructions by class and stage, " + view.caption() + ".", spec(view),
                rows(view, "Class", class_of)},
          Chart{"mnemonics",
                "The 20 instructions that are issued most, by stage, " + view.caption() + ".",
                spec(view), rows(view, "Instruction", mnemonic_of)}};
}

}  // namespace

extern const Section s_mix{"mix", "Instruction mix",
                           "What is issued for each micropolygon that is rasterized.", build};

}  // namespace lanescope
