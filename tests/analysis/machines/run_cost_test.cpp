// SPDX-License-Identifier: MIT
// Costs of runs on machines, from counts made by hand.
#include "analysis/machines/run_cost.h"

#include <gtest/gtest.h>

#include "analysis/machines/cost_tables.h"
#include "analysis/machines/crossover_tables.h"
#include "tests/analysis/charts.h"
#include "tests/analysis/configured.h"
#include "tests/analysis/machines/sample_machine.h"

namespace lanescope {
namespace {

using testing::four_lanes;

/// A run of one stage for 10 elements.
RunRecord run_of(const std::string& kernel, unsigned width,
                 const std::vector<InstructionRecord>& instructions) {
  RunRecord run;
  run.configuration =
      testing::configured({{"kernel", kernel}, {"width_lanes", width}, {"scene", "teapot"}});
  run.workload = "micropolygons";
  run.element = {"rasterized", "micropolygon", "mp"};
  run.counters = {{"rasterized", "", "micropolygons", 10}};
  run.stages = {{"Test", instructions, {}, {}, {}, {}}};
  return run;
}

Report report_of(std::vector<RunRecord> runs) {
  Report report;
  report.instructions = {{"add", "", "arithmetic", "active_lanes"},
                         {"gather", "", "memory", "active_lanes"},
                         {"hmax", "", "reduce", "active_lanes"},
                         {"everywhere", "", "memory", "all_lanes"},
                         {"strange", "", "special", "active_lanes"}};
  report.runs = std::move(runs);
  return report;
}

/// Slots and useful slots of the only run of a report.
SlotSum cost_of(const Report& report, const MachineDescription& machine) {
  SequenceTrials trials;
  return ReportCosts(report, machine, trials)
      .of(report.runs.front())
      .total()
      .value_or(SlotSum{-1, -1});
}

TEST(RunCosts, CountEveryGroupOfAVector) {
  // Ten vectors of 6 lanes are two groups of 4 each; 30 lanes are on, 7.5 full groups.
  const SlotSum sum = cost_of(report_of({run_of("lockstep", 6, {{"add", 10, 30}})}), four_lanes());
  EXPECT_DOUBLE_EQ(sum.slots, 20.0);
  EXPECT_DOUBLE_EQ(sum.useful, 7.5);
}

TEST(RunCosts, CountInstructionsAndLanes) {
  const MachineDescription machine = four_lanes(
      R"(, "instructions": {"add": {"slots": {"instruction": 1, "lane": 2}, "source": "assumed"}})");
  const SlotSum sum = cost_of(report_of({run_of("lockstep", 8, {{"add", 10, 30}})}), machine);
  EXPECT_DOUBLE_EQ(sum.slots, 10.0 + 60.0);
  EXPECT_DOUBLE_EQ(sum.useful, 30.0 / 8.0 + 60.0);
}

TEST(RunCosts, CountPairsOfGroups) {
  const MachineDescription machine =
      four_lanes(R"(, "instructions": {"add": {"slots": {"group_pair": 1}, "source": "assumed"}})");
  EXPECT_DOUBLE_EQ(cost_of(report_of({run_of("lockstep", 16, {{"add", 2, 32}})}), machine).slots,
                   2.0 * 16.0);
}

TEST(RunCosts, TakeGroupsFromThePiecesObserved) {
  const MachineDescription machine = four_lanes(
      R"(, "instructions": {"add": {"slots": {"active_group": 1}, "source": "assumed"},
                            "sub": {"slots": {"dense_group": 1}, "source": "assumed"}})");
  Report report = report_of({run_of("lockstep", 16, {{"add", 100, 300}})});
  EXPECT_EQ(cost_of(report, machine).slots, -1.0) << "nothing was observed";
  // Ten of the hundred, with lanes in 12 groups of 4.
  StageRecord& stage = report.runs[0].stages[0];
  stage.lane_groups = {{"add", 10, {{30, 20, 12, 11, 10, 10, 10}, {30, 18, 11, 10, 10, 10, 10}}}};
  EXPECT_DOUBLE_EQ(cost_of(report, machine).slots, 120.0);
  // What was issued in other pieces only is as the rest of its stage.
  stage.instructions = {{"sub", 50, 150}};
  report.instructions.push_back({"sub", "", "arithmetic", "active_lanes"});
  EXPECT_DOUBLE_EQ(cost_of(report, machine).slots, 55.0);
}

TEST(RunCosts, TakeLinesFromThePiecesObserved) {
  const MachineDescription machine =
      four_lanes(R"(, "instructions": {"gather": {"slots": {"line": 2}, "source": "assumed"}})");
  Report report = report_of({run_of("lockstep", 8, {{"gather", 40, 200}})});
  report.runs[0].stages[0].memory = {{"gather", 4, 20, 14, {}, 0}};
  EXPECT_DOUBLE_EQ(cost_of(report, machine).slots, 2.0 * 14.0 * 10.0);
  SequenceTrials trials;
  EXPECT_TRUE(ReportCosts(report, machine, trials).from_observed());
}

TEST(RunCosts, OfLanesThatAreNotChargedComeFromThePiecesObserved) {
  const MachineDescription machine =
      four_lanes(R"(, "own": {"everywhere": {"slots": {"lane": 1}, "source": "assumed"}})");
  Report report = report_of({run_of("lockstep", 8, {{"everywhere", 10, 80}})});
  report.runs[0].stages[0].lane_groups = {{"everywhere", 5, {{15}, {15}}}};
  EXPECT_DOUBLE_EQ(cost_of(report, machine).slots, 30.0);
}

TEST(RunCosts, ArePricedBySequences) {
  // At W = 8, in groups of 4: select 2; shuffle and max of 4, 2 and 1 lanes, a group each; then
  // the lane.
  const MachineDescription machine =
      four_lanes(R"(, "instructions": {"hmax": {"sequence": "hmax_by_shuffles"}})");
  const Report report = report_of({run_of("lockstep", 8, {{"hmax", 3, 24}})});
  EXPECT_DOUBLE_EQ(cost_of(report, machine).slots, 3.0 * (2.0 + 3.0 * 2.0 + 1.0));
  // In turn: a shuffle that takes three slots.
  const MachineDescription slow_shuffle = four_lanes(
      R"(, "instructions": {"hmax": {"sequence": "hmax_by_shuffles"},
                            "shuffle_down": {"slots": {"every_group": 3}, "source": "assumed"}})");
  EXPECT_DOUBLE_EQ(cost_of(report, slow_shuffle).slots, 3.0 * (2.0 + 3.0 * 4.0 + 1.0));
}

TEST(RunCosts, OfLaneByLaneSequencesAreOfTheLanesThatAreOn) {
  const MachineDescription machine =
      four_lanes(R"(, "instructions": {"gather": {"sequence": "gather_by_lanes"}})");
  EXPECT_DOUBLE_EQ(cost_of(report_of({run_of("lockstep", 8, {{"gather", 10, 30}})}), machine).slots,
                   30.0 * 2.0);
}

TEST(RunCosts, OfSequencesUnderTheMaskOfTheInstructionAreOfItsLanes) {
  // A pair by two gathers: a shift of whole groups, and two slots a lane for each gather.
  const MachineDescription machine =
      four_lanes(R"(, "instructions": {"gather": {"sequence": "gather_by_lanes"},
                                       "gather_pair": {"sequence": "gather_pair_by_gathers"}})");
  Report report = report_of({run_of("lockstep", 8, {{"gather_pair", 10, 30}})});
  report.instructions.push_back({"gather_pair", "", "memory", "active_lanes"});
  EXPECT_DOUBLE_EQ(cost_of(report, machine).slots, 10.0 * 2.0 + 30.0 * 2.0 * 2.0);
  // Each gather touches the lines of the pair.
  const MachineDescription by_line =
      four_lanes(R"(, "instructions": {"gather": {"slots": {"line": 1}, "source": "assumed"},
                                       "gather_pair": {"sequence": "gather_pair_by_gathers"}})");
  report.runs[0].stages[0].memory = {{"gather_pair", 10, 30, 25, {}, 0}};
  EXPECT_DOUBLE_EQ(cost_of(report, by_line).slots, 10.0 * 2.0 + 2.0 * 25.0);
}

TEST(RunCosts, OfWhatIsUnknownAreNone) {
  const MachineDescription machine = four_lanes(R"(, "instructions": {"add": "unknown"})");
  const Report report = report_of({run_of("lockstep", 8, {{"add", 1, 8}, {"hmax", 1, 8}})});
  SequenceTrials trials;
  const ReportCosts costs(report, machine, trials);
  EXPECT_FALSE(costs.of(report.runs[0]).total());
  EXPECT_FALSE(costs.slots_per_element(report.runs[0], "Test"));
  EXPECT_EQ(costs.missing(), std::set<std::string>{"add"});
  const TableData table = cost_table(ReportView(report), costs);
  EXPECT_EQ(shown(table.rows.at(table.rows.size() - 2).cells.front()), "n/a (n/a)");
  EXPECT_EQ(shown(table.rows.back().cells.front()), "add");
  EXPECT_EQ(table.notes.at(1).substr(0, 33), "There are no totals on four where");
  const auto json = cost_json(report, costs);
  EXPECT_TRUE(json["runs"][0]["slots"].is_null());
  EXPECT_TRUE(json["runs"][0]["stages"][0]["slots"].is_null());
  EXPECT_EQ(json["runs"][0]["missing"][0], "add");
}

TEST(RunCosts, SayWhatIsPricedByClass) {
  const Report report = report_of({run_of("lockstep", 8, {{"strange", 1, 8}})});
  SequenceTrials trials;
  const MachineDescription machine = four_lanes();
  EXPECT_EQ(ReportCosts(report, machine, trials).priced_by_class(),
            (std::set<std::string>{"everywhere", "strange"}));
  const MachineDescription named =
      four_lanes(R"(, "own": {"strange": "unknown", "everywhere": "unknown"})");
  EXPECT_TRUE(ReportCosts(report, named, trials).priced_by_class().empty());
}

/// LOCKSTEP issues adds only; REPACK fewer, the more lanes, and hmax beside them.
Report two_kernels() {
  std::vector<RunRecord> runs;
  for (const unsigned width : {4u, 8u, 16u}) {
    runs.push_back(run_of("lockstep", width, {{"add", 100, 100}}));
    runs.push_back(run_of("repack", width, {{"add", 400 / width, 100}, {"hmax", 50, 50}}));
  }
  return report_of(std::move(runs));
}

TEST(Crossovers, AreWhereTheRatioIsOne) {
  // Ratios 1.5, 1 and 0.75 where all is one slot, at any width.
  const MachineDescription flat =
      testing::machine_from(R"({"name": "flat", "summary": "flat", "inherits": "thesis"})");
  const Report report = two_kernels();
  const ReportView view(report);
  const auto all = crossovers(view, "lockstep", "repack", {flat});
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].crossover.widths.size(), 3u);
  EXPECT_DOUBLE_EQ(all[0].crossover.widths[0].ratio(), 1.5);
  EXPECT_DOUBLE_EQ(all[0].crossover.widths[2].ratio(), 0.75);
  EXPECT_DOUBLE_EQ(all[0].crossover.crossing.value_or(0), 8.0);
  EXPECT_EQ(all[0].crossover.words(), "8.0");
}

TEST(Crossovers, AreMovedByTheCostOfAnInstruction) {
  const MachineDescription flat =
      testing::machine_from(R"({"name": "flat", "summary": "flat", "inherits": "thesis"})");
  const Report report = two_kernels();
  SequenceTrials trials;
  const auto pairs = pairs_of(ReportView(report), "lockstep", "repack");
  ASSERT_EQ(pairs.size(), 1u);
  const auto all = sensitivities(ReportView(report), pairs, flat, trials)[0];
  ASSERT_EQ(all.size(), 2u);
  // hmax at half: 1.25, 0.75, ...: from 1.25 to 0.75 the middle of 4 and 8. At double:
  // 2, 1.5, 1.25.
  const auto hmax =
      std::find_if(all.begin(), all.end(), [](auto& s) { return s.mnemonic == "hmax"; });
  EXPECT_EQ(hmax->halved.words(), "5.7");
  EXPECT_EQ(hmax->doubled.words(), "above 16");
  EXPECT_NEAR(hmax->moved(), 4.0 - 2.5, 1e-9);
  // At W = 16: 10 slots an element against 2.5 and 5 for each of its cost.
  EXPECT_NEAR(hmax->break_even().value_or(0), 1.5, 1e-9);
  EXPECT_EQ(all.front().mnemonic, "hmax") << "what is issued in one kernel only moves it more";
}

TEST(Crossovers, OfUnknownCostsAreUnknown) {
  const MachineDescription flat = testing::machine_from(
      R"({"name": "flat", "summary": "flat", "inherits": "thesis",
          "instructions": {"hmax": "unknown"}})");
  const Report report = two_kernels();
  const auto all = crossovers(ReportView(report), "lockstep", "repack", {flat});
  EXPECT_EQ(all.at(0).crossover.words(), "unknown");
  EXPECT_TRUE(all[0].sensitivities.empty());
  const TableData table = crossover_table(ReportView(report), all);
  EXPECT_EQ(shown(table.rows.back().cells.at(2)), "n/a");
  const auto json = crossover_json(all[0]);
  EXPECT_TRUE(json["crossing"].is_null());
  EXPECT_EQ(json["missing"][0], "hmax");
}

TEST(Crossovers, SayOnWhichSideTheyLie) {
  Crossover behind{{{8, 1.0, 0.5}, {16, 1.0, 1.5}}, 11.3};
  EXPECT_EQ(behind.words(), "falls behind at 11.3");
  Crossover below{{{8, 1.0, 0.5}, {16, 1.0, 0.4}}, {}};
  EXPECT_EQ(below.words(), "below 8");
}

TEST(MachinesSection, ShowsTheRatioOnEveryMachine) {
  // At 4, 8 and 16 lanes, but on the machine that must know masks, which nobody observed.
  const Report report = two_kernels();
  const Chart ratios = testing::chart_of(sections(), ReportView(report), "machines", "ratios");
  EXPECT_EQ(ratios.rows.rows().size(), 3 * (shipped_machines().size() - 1));
  EXPECT_EQ(testing::last_of(ratios, {"thesis", "micropolygon = triangle", 16}), 0.75);
  const Chart crossings =
      testing::chart_of(sections(), ReportView(report), "machines", "crossings");
  EXPECT_EQ(testing::last_of(crossings, {"thesis"}), "hmax");
}

TEST(MachinesSection, NeedsTwoKernels) {
  const Report report = report_of({run_of("lockstep", 8, {{"add", 1, 8}})});
  for (const Section* section : sections())
    if (section->id == "machines") {
      EXPECT_TRUE(section->build(ReportView(report)).empty());
    }
}

}  // namespace
}  // namespace lanescope
