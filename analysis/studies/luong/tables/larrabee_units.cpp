// SPDX-License-Identifier: MIT
// The thesis's estimate of how much hardware rasterization takes (4.3).
#include <fmt/format.h>

#include "analysis/machines/run_cost.h"
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"
#include "analysis/tables/series_rows.h"

namespace lanescope::luong {
namespace {

constexpr std::string_view kMachine = "larrabee";
constexpr Unit kBillions{"1/s", 1e-9, " G/s", 1, 0, Difference::kRelative};
constexpr Unit kUnits{"units", 1.0, "", 1, 0, Difference::kRelative};

std::optional<double> estimate(std::string_view name) {
  return thesis_value({"text_claims", "larrabee_units_at_60fps", name});
}

/// Slots of an instruction on the machine, of all stages but Setup.
std::optional<double> slots_of_an_instruction(const ReportView& view, const Series& series,
                                              const ReportCosts& costs) {
  return view.mean(series, kClaimWidth, [&](const RunRecord& run) -> std::optional<double> {
    const auto all = costs.slots_per_element(run);
    const double setup = costs.slots_per_element(run, kSetup).value_or(0.0);
    return all ? quotient(*all - setup, instructions_per_element(run, kAllButSetup)) : std::nullopt;
  });
}

Row row_of(const ReportView& view, const Series& series, bool before_culling,
           const ReportCosts& costs) {
  const auto instructions = instructions_per_second(view, series, before_culling);
  const auto each = slots_of_an_instruction(view, series, costs);
  const auto slots = instructions && each ? std::optional(*instructions * *each) : std::nullopt;
  const bool quads = series.facet == kQuad;
  const auto units = estimate(quads ? "quads" : "triangles");
  const auto operations = quads ? std::nullopt : estimate("vector_ops_per_second");
  return {fmt::format("{}, {}", shown_kernel(series.kernel), plural(series.facet)),
          {{Figure{instructions, operations, &kBillions}, {}, {}},
           {Figure{quotient(instructions, instructions_of_a_unit()), units, &kUnits}, {}, {}},
           {Figure{slots, {}, &kBillions}, {}, {}},
           {Figure{quotient(slots, instructions_of_a_unit()), {}, &kUnits}, {}, {}}}};
}

TableData build(const ReportView& view) {
  SequenceTrials trials;
  const MachineDescription machine = machine_of("machine", std::string(kMachine));
  const ReportCosts costs(view.report(), machine, trials);
  TableData data;
  data.title =
      fmt::format("What {} frames a second take at W = {} (4.3)", kFramesPerSecond, kClaimWidth);
  data.row_header = "Kernel";
  data.columns = {"Instructions", "Units", "Slots on larrabee", "Units by slots"};
  for (const bool before_culling : {false, true}) {
    data.rows.push_back(
        {before_culling ? "Micropolygons before culling" : "Micropolygons rasterized", {}});
    for (const Series& series : {kLockstepTriangle, kRepackTriangle, kLockstepQuad, kRepackQuad})
      data.rows.push_back(row_of(view, series, before_culling, costs));
  }
  data.notes = {
      "Without Setup. A unit is a Larrabee core as the thesis has it: 22 billion instructions a "
      "second over 20 units. The thesis names no kernel, as both issue almost the same at this W; "
      "its 22 billion come out only with the micropolygons before culling, as if those that are "
      "culled cost as much as the others.",
      "Slots are those of the machine larrabee (docs/machines.md), on which not every instruction "
      "is one. Groups and lines are those of the pieces of work that were observed."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_larrabee_units{"larrabee_units",
                                          "4.3: how many Larrabee units 60 frames a second take",
                                          luong::compared<luong::build>};

}  // namespace lanescope
