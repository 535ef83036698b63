// SPDX-License-Identifier: MIT
#include "analysis/machines/crossover_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "analysis/base/json_text.h"
#include "analysis/machines/cost_tables.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// `scatter (12.1 to 25.3)`: the crossing with its cost halved and doubled; if that does not move
/// it, `scatter (1.62x to 2.04x at W = 64; even at 0.31 of its cost)`: the ratio at the widest of
/// the widths.
std::string shown_sensitivity(const MachineCrossover& one) {
  if (one.sensitivities.empty()) return "";
  const Sensitivity& most = one.sensitivities.front();
  if (most.moved() > 0.0)
    return fmt::format("{} ({} to {})", most.mnemonic, most.halved.words(), most.doubled.words());
  const SlotsAtWidth& halved = most.halved.widths.back();
  const auto even = most.break_even();
  return fmt::format("{} ({:.2f}x to {:.2f}x at W = {}{})", most.mnemonic, halved.ratio(),
                     most.doubled.widths.back().ratio(), halved.width,
                     even ? fmt::format("; even at {:.2f} of its cost", *even) : "");
}

Row row_of(const MachineCrossover& one, const std::vector<int>& widths) {
  Row row{one.machine.name, {}};
  row.cells.push_back({{}, {}, one.crossover.words()});
  row.cells.push_back({{}, {}, shown_sensitivity(one)});
  for (const int width : widths) {
    const auto& at = one.crossover.widths;
    const auto found = std::find_if(at.begin(), at.end(),
                                    [&](const SlotsAtWidth& each) { return each.width == width; });
    row.cells.push_back(
        {Figure{found == at.end() ? std::nullopt : std::optional(found->ratio()), {}, &kFactor},
         {},
         {}});
  }
  row.cells.push_back({{}, {}, hash_text(one.machine.hash)});
  return row;
}

Json widths_json(const Crossover& crossover) {
  Json list = Json::array();
  for (const SlotsAtWidth& at : crossover.widths)
    list.push_back({{"width_lanes", at.width},
                    {"first_slots_per_element", at.first},
                    {"second_slots_per_element", at.second},
                    {"ratio", at.ratio()}});
  return list;
}

Json sensitivity_json(const Sensitivity& one) {
  return {{"mnemonic", one.mnemonic},
          {"halved",
           {{"crossing", number_or_null(one.halved.crossing)}, {"words", one.halved.words()}}},
          {"doubled",
           {{"crossing", number_or_null(one.doubled.crossing)}, {"words", one.doubled.words()}}},
          {"moved_log2", one.moved()},
          {"ratio_changed_log2", one.changed()},
          {"break_even_factor", number_or_null(one.break_even())}};
}

}  // namespace

std::vector<MachineCrossover> crossovers(const ReportView& view, const std::string& first,
                                         const std::string& second,
                                         const std::vector<MachineDescription>& machines) {
  SequenceTrials trials;
  const std::vector<KernelPair> pairs = pairs_of(view, first, second);
  std::vector<std::vector<MachineCrossover>> by_pair(pairs.size());
  for (const MachineDescription& machine : machines) {
    const ReportCosts costs(view.report(), machine, trials);
    auto of_pairs = sensitivities(view, pairs, machine, trials);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      std::erase_if(of_pairs[i], [](const Sensitivity& each) { return each.changed() == 0.0; });
      by_pair[i].push_back({machine, pairs[i], crossover(view, pairs[i], costs),
                            std::move(of_pairs[i]), notes_on(costs), costs.missing()});
    }
  }
  std::vector<MachineCrossover> all;
  for (std::vector<MachineCrossover>& each : by_pair)
    std::move(each.begin(), each.end(), std::back_inserter(all));
  return all;
}

TableData crossover_table(const ReportView& view, const std::vector<MachineCrossover>& all) {
  TableData data;
  if (all.empty()) return data;
  const std::string first = shown_kernel(all.front().pair.first.kernel);
  const std::string second = shown_kernel(all.front().pair.second.kernel);
  const std::vector<int> widths = machine_widths_of(view.report());
  data.name = "crossover";
  data.caption = view.caption();
  data.setting = view.setting();
  data.title = fmt::format("Width from which {} takes fewer issue slots than {}", second, first);
  data.row_header = "Machine";
  data.columns = {"Crossing", "Moved most by (halved to doubled)"};
  for (const std::string& header : width_headers(widths)) data.columns.push_back(header);
  data.columns.push_back("Description");
  std::string facet;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string own = shown_facet(all[i].pair.first);
    if (i == 0 || own != facet)
      if (!own.empty()) data.rows.push_back({own, {}});
    facet = own;
    data.rows.push_back(row_of(all[i], widths));
  }
  data.notes = {
      fmt::format("At each W: slots of {} over those of {}, for each element, of all stages. "
                  "Between widths the ratio is interpolated linearly over log2 W.",
                  second, first),
      "Moved most by: the instruction of which half and double the cost lead to the crossings in "
      "parentheses, or to these ratios where neither leads to a crossing. A slot is the time of "
      "one addition of floats in a vector of the machine."};
  for (const MachineCrossover& one : all)
    for (const std::string& note : one.notes)
      if (std::find(data.notes.begin(), data.notes.end(), note) == data.notes.end())
        data.notes.push_back(note);
  return data;
}

Json crossover_json(const MachineCrossover& one) {
  Json sensitivities = Json::array();
  for (const Sensitivity& each : one.sensitivities) sensitivities.push_back(sensitivity_json(each));
  Json json = machine_json(one.machine);
  json["first"] = one.pair.first.kernel;
  json["second"] = one.pair.second.kernel;
  json["facet"] = one.pair.first.facet;
  json["crossing"] = number_or_null(one.crossover.crossing);
  json["words"] = one.crossover.words();
  json["widths"] = widths_json(one.crossover);
  json["sensitivities"] = std::move(sensitivities);
  json["missing"] = one.missing;
  return json;
}

}  // namespace lanescope
