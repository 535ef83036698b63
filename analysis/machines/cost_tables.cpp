// SPDX-License-Identifier: MIT
#include "analysis/machines/cost_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/base/json_text.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

std::string list_of(const std::set<std::string>& names) {
  return list_and(std::vector<std::string>(names.begin(), names.end()));
}

/// Figures of runs, as means over the scenes of the view.
Cell mean_cell(const ReportView& view, const Series& series, int width, const RunFigure& slots,
               const RunFigure& utilization) {
  return {Figure{view.mean(series, width, slots), {}, &kSlots},
          Figure{view.mean(series, width, utilization), {}, &kShare},
          {}};
}

/// What is missing at each width, for formats that have no notes.
Row missing_row(const ReportView& view, const Series& series, const ReportCosts& costs) {
  return row_over(view, series, "Not known", [&](int width) {
    std::set<std::string> missing;
    for (const RunRecord* run : view.runs(series, width))
      missing.insert(costs.of(*run).missing.begin(), costs.of(*run).missing.end());
    return Cell{{}, {}, list_of(missing)};
  });
}

std::vector<Row> cost_rows(const ReportView& view, const Series& series, const ReportCosts& costs) {
  std::vector<Row> rows;
  for (const std::string& stage : stages_of(view, series))
    rows.push_back(row_over(view, series, stage, [&](int width) {
      return mean_cell(
          view, series, width,
          [&](const RunRecord& run) { return costs.slots_per_element(run, stage); },
          [&](const RunRecord& run) { return costs.utilization(run, stage); });
    }));
  if (rows.empty()) return rows;
  rows.push_back(row_over(
      view, series, fmt::format("Slots/{}, all stages", element_of(view, series)), [&](int width) {
        return mean_cell(
            view, series, width, [&](const RunRecord& run) { return costs.slots_per_element(run); },
            [&](const RunRecord& run) { return costs.utilization(run); });
      }));
  if (!costs.missing().empty()) rows.push_back(missing_row(view, series, costs));
  return rows;
}

Json run_json(const RunRecord& run, const ReportCosts& costs) {
  const RunCost& cost = costs.of(run);
  const bool is_known = cost.missing.empty();
  const auto total = cost.total();
  Json stages = Json::array();
  for (std::size_t i = 0; i < run.stages.size(); ++i) {
    const std::string& name = run.stages[i].name;
    stages.push_back({{"name", name},
                      {"slots", is_known ? Json(cost.stages[i].slots) : Json(nullptr)},
                      {"slots_per_element", number_or_null(costs.slots_per_element(run, name))},
                      {"utilization", number_or_null(costs.utilization(run, name))}});
  }
  return {{"parameters", configuration_json(run.configuration)},
          {"slots", total ? Json(total->slots) : Json(nullptr)},
          {"slots_per_element", number_or_null(costs.slots_per_element(run))},
          {"utilization", number_or_null(costs.utilization(run))},
          {"stages", std::move(stages)},
          {"missing", cost.missing},
          {"from_observed", cost.from_observed}};
}

/// `1 every_group + 3 lane`.
std::string shown_slots(const ByBasis& slots) {
  std::vector<std::string> terms;
  for (const auto& [name, basis] : kSlotBases)
    if (at(slots, basis) != 0.0) terms.push_back(fmt::format("{} {}", at(slots, basis), name));
  return terms.empty() ? "0" : fmt::format("{}", fmt::join(terms, " + "));
}

/// `1 every_group`, `4 lane (assumed)`, `scatter_by_lanes`.
std::string shown_figure(const SlotFigure* figure) {
  if (!figure || !figure->known) return "unknown";
  std::vector<std::string> terms;
  if (!figure->source.empty())
    terms.push_back(shown_slots(figure->slots) + (figure->source == kAssumed ? " (assumed)" : ""));
  if (figure->sequence) terms.push_back(fmt::format("`{}`", figure->sequence->name));
  return fmt::format("{}", fmt::join(terms, " and "));
}

}  // namespace

std::string shown_machine(const MachineDescription& machine) {
  return fmt::format("{} ({}, {})", machine.name,
                     machine.lanes ? fmt::format("{} lanes", *machine.lanes) : "W lanes",
                     hash_text(machine.hash));
}

std::vector<std::string> notes_on(const ReportCosts& costs) {
  std::vector<std::string> notes;
  if (const auto missing = costs.missing(); !missing.empty())
    notes.push_back(fmt::format(
        "There are no totals on {} where it is not known what this takes: {}. Give it figures in a "
        "description that inherits from it.",
        costs.machine().name, list_of(missing)));
  if (const auto by_class = costs.priced_by_class(); !by_class.empty())
    notes.push_back(fmt::format("On {}, by the figure of their class: {}.", costs.machine().name,
                                list_of(by_class)));
  if (costs.from_observed())
    notes.push_back(fmt::format(
        "On {}, groups of lanes and lines of memory are those of the pieces of work that were "
        "observed (observe_every), in proportion to what was issued.",
        costs.machine().name));
  return notes;
}

TableData cost_table(const ReportView& view, const ReportCosts& costs) {
  TableData data = table_over_widths(
      view, fmt::format("Issue slots for each element on {} (utilization)", costs.machine().name),
      "Stage",
      [&](const ReportView& of, const Series& series) { return cost_rows(of, series, costs); });
  data.name = "machine_" + costs.machine().name;
  data.caption = view.caption();
  data.setting = fmt::format("machine = {}, {}", shown_machine(costs.machine()), view.setting());
  data.notes = {"A slot is the time of one addition of floats in a vector of the machine."};
  for (std::string& note : notes_on(costs)) data.notes.push_back(std::move(note));
  return data;
}

Json machine_json(const MachineDescription& machine) {
  return {{"name", machine.name},
          {"hash", hash_text(machine.hash)},
          {"lanes", machine.lanes ? Json(*machine.lanes) : Json(nullptr)}};
}

Json cost_json(const Report& report, const ReportCosts& costs) {
  Json runs = Json::array();
  for (const RunRecord& run : report.runs) runs.push_back(run_json(run, costs));
  Json json = machine_json(costs.machine());
  json["priced_by_class"] = costs.priced_by_class();
  json["runs"] = std::move(runs);
  return json;
}

std::string machine_prices(const InstructionInfo& instruction) {
  std::vector<std::pair<std::string, std::string>> machines_by_figure;
  for (const MachineDescription& machine : shipped_machines()) {
    const std::string figure =
        shown_figure(machine.find(instruction.mnemonic, to_string(instruction.instruction_class)));
    const auto same =
        std::ranges::find(machines_by_figure, figure, &std::pair<std::string, std::string>::first);
    if (same == machines_by_figure.end())
      machines_by_figure.emplace_back(figure, machine.name);
    else
      same->second += ", " + machine.name;
  }
  std::string text = "- On [machines](machines.md):";
  std::string_view separator = " ";
  for (const auto& [figure, machines] : machines_by_figure) {
    text += fmt::format("{}{} on {}", separator, figure, machines);
    separator = "; ";
  }
  return text + ".\n";
}

}  // namespace lanescope
