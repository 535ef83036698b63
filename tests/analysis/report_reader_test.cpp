// SPDX-License-Identifier: MIT
// What reports are refused for, and with which words.
#include <gtest/gtest.h>

#include "analysis/base/json_text.h"
#include "analysis/report/report_json.h"
#include "simulator/base/error.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// A change to a good report, and the complaint about it.
struct BadReport {
  const char* name;
  void (*spoil)(Json&);
  std::string message;
};

void PrintTo(const BadReport& bad, std::ostream* out) { *out << bad.name; }

class BadReports : public ::testing::TestWithParam<BadReport> {};

TEST_P(BadReports, AreRefusedWithTheirPlace) {
  Json json = to_json(testing::sample_report());
  GetParam().spoil(json);
  try {
    parse_report(json_text(json), "r.json");
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().message);
  }
}

/// The memory instruction of Process in the first run.
Json& memory_of(Json& report) { return report["runs"][0]["stages"][3]["memory"][0]; }

/// The groups of lanes of that instruction, of which two were on.
Json& with_groups(Json& report) {
  Json& groups = report["runs"][0]["stages"][3]["lane_groups"];
  groups = Json::parse(R"([{"mnemonic": "scatter", "issued": 1,
                            "active_groups": [2, 2, 1, 1, 1, 1, 1],
                            "dense_groups": [2, 1, 1, 1, 1, 1, 1]}])");
  return groups[0];
}

TEST(GroupsOfLanes, AreReadAsTheyAreWritten) {
  Json json = to_json(testing::sample_report());
  with_groups(json);
  const Report read = parse_report(json_text(json), "r.json");
  EXPECT_EQ(to_json(read), json);
  const LaneGroupRecord& record = read.runs[0].stages[3].lane_groups.at(0);
  EXPECT_EQ(record.groups.active[1], 2u);
  EXPECT_EQ(record.groups.dense[1], 1u);
}

TEST(GroupsOfLanes, AreNotInReportsOfEarlierPrograms) {
  Json json = to_json(testing::sample_report());
  for (Json& run : json["runs"])
    for (Json& stage : run["stages"]) stage.erase("lane_groups");
  EXPECT_TRUE(parse_report(json_text(json), "r.json").runs[0].stages[0].lane_groups.empty());
}

const std::vector<BadReport> kBadReports{
    {"NotAnObject", [](Json& j) { j = Json::array(); }, "r.json:/: an array is not an object"},
    {"NoSchema", [](Json& j) { j.erase("schema"); }, "r.json:/: the member 'schema' is missing"},
    {"OtherSchema", [](Json& j) { j["schema"]["name"] = "other"; },
     "r.json:/schema/name: \"other\" is not \"lanescope-report\""},
    {"NewerVersion", [](Json& j) { j["schema"]["version"] = 4; },
     "r.json:/schema/version: version 4 is newer than 3, the only one that this program reads"},
    {"OlderVersion", [](Json& j) { j["schema"]["version"] = 2; },
     "r.json:/schema/version: version 2 is older than 3, the only one that this program reads; "
     "make the report again, as with `lanescope tables`"},
    {"FirstVersion",
     [](Json& j) {
       j = {{"schema", {{"name", "lanescope-report"}, {"version", 1}}},
            {"made_by", {{"command", "lanescope run --scene 'a b'"}}},
            {"other", 1}};
     },
     "r.json:/schema/version: version 1 is older than 3, the only one that this program reads; "
     "make the report again, as with `lanescope run --scene 'a b'`"},
    {"OlderVersionOfUnknownMaker",
     [](Json& j) {
       j["schema"]["version"] = 2;
       j.erase("made_by");
     },
     "r.json:/schema/version: version 2 is older than 3, the only one that this program reads; "
     "make the report again, as with `lanescope run --json`"},
    {"OlderVersionOfOtherCommand",
     [](Json& j) {
       j["schema"]["version"] = 2;
       j["made_by"]["command"] = 5;
     },
     "r.json:/schema/version: version 2 is older than 3, the only one that this program reads; "
     "make the report again, as with `lanescope run --json`"},
    {"OlderVersionOfTwoLines",
     [](Json& j) {
       j["schema"]["version"] = 2;
       j["made_by"]["command"] = "lanescope\nrun";
     },
     "r.json:/schema/version: version 2 is older than 3, the only one that this program reads; "
     "make the report again, as with `lanescope run --json`"},
    {"VersionZero", [](Json& j) { j["schema"]["version"] = 0; },
     "r.json:/schema/version: 0 is not an integer of at least 1"},
    {"VersionAsText", [](Json& j) { j["schema"]["version"] = "1"; },
     "r.json:/schema/version: \"1\" is not an integer of at least 1"},
    {"UnknownMember", [](Json& j) { j["run"] = 1; },
     "r.json:/: unknown member 'run'; did you mean 'runs'?"},
    {"OtherProgram", [](Json& j) { j["made_by"]["program"] = "x"; },
     "r.json:/made_by/program: \"x\" is not \"lanescope\""},
    {"RunsAsObject", [](Json& j) { j["runs"] = Json::object(); },
     "r.json:/runs: an object is not an array"},
    {"RunAsNumber", [](Json& j) { j["runs"][1] = 5; }, "r.json:/runs/1: 5 is not an object"},
    {"KernelAsNumber", [](Json& j) { j["runs"][0]["parameters"]["kernel"] = 5; },
     "r.json:/runs/0/parameters/kernel: 5 is not a string"},
    {"WidthTooLarge", [](Json& j) { j["runs"][0]["parameters"]["width_lanes"] = 65; },
     "r.json:/runs/0/parameters/width_lanes: 65 is not an integer from 1 to 64"},
    {"WidthAsFraction", [](Json& j) { j["runs"][0]["parameters"]["width_lanes"] = 8.5; },
     "r.json:/runs/0/parameters/width_lanes: 8.5 is not an integer from 1 to 64"},
    {"HugeInteger", [](Json& j) { j["runs"][0]["parameters"]["width_lanes"] = 0xffffffffffffffff; },
     "r.json:/runs/0/parameters/width_lanes: 18446744073709551615 is not an integer from 1 to 64"},
    {"OtherShape", [](Json& j) { j["runs"][0]["parameters"]["micropolygon"] = "pentagon"; },
     "r.json:/runs/0/parameters/micropolygon: \"pentagon\" is not triangle or quad"},
    {"OtherMode", [](Json& j) { j["runs"][0]["parameters"]["mode"] = "fast"; },
     "r.json:/runs/0/parameters/mode: \"fast\" is not counting, checked or uncounted"},
    {"SwitchAsNumber", [](Json& j) { j["runs"][0]["parameters"]["jitter"] = 1; },
     "r.json:/runs/0/parameters/jitter: 1 is not true or false"},
    {"NegativeSeed", [](Json& j) { j["runs"][0]["parameters"]["seed"] = -1; },
     "r.json:/runs/0/parameters/seed: -1 is not an integer from 0 to 2^64 - 1"},
    {"ThresholdAboveAll", [](Json& j) { j["runs"][1]["parameters"]["stream_load_threshold"] = 7; },
     "r.json:/runs/1/parameters/stream_load_threshold: 7 is not a number from 0 to 1"},
    {"ParameterOfAnotherKernel",
     [](Json& j) { j["runs"][0]["parameters"]["stream_load_threshold"] = 0; },
     "r.json:/runs/0/parameters: unknown member 'stream_load_threshold'"},
    {"WidthAsNull", [](Json& j) { j["runs"][0]["parameters"]["width_lanes"] = nullptr; },
     "r.json:/runs/0/parameters/width_lanes: null is not an integer from 1 to 64"},
    {"ListAsParameterOfAnUnknownKernel",
     [](Json& j) {
       j["runs"][0]["parameters"]["kernel"] = "another";
       j["runs"][0]["parameters"]["edges"] = Json::array();
     },
     "r.json:/runs/0/parameters/edges: an array is not a value of a parameter"},
    {"HugeParameterOfAnUnknownKernel",
     [](Json& j) {
       j["runs"][0]["parameters"]["kernel"] = "another";
       j["runs"][0]["parameters"]["edges"] = 1e300;
     },
     "r.json:/runs/0/parameters/edges: 1e+300 is not a value of a parameter"},
    {"OtherWorkload", [](Json& j) { j["runs"][0]["workload"] = "micropolygon"; },
     "r.json:/runs/0/workload: \"micropolygon\" is not \"micropolygons\", the kind of work of "
     "lockstep"},
    {"ElementThatIsNoCounter", [](Json& j) { j["runs"][0]["element"]["counter"] = "rasterized"; },
     "r.json:/runs/0/element/counter: \"rasterized\" is not the name of a counter of this run"},
    {"ElementWithoutName", [](Json& j) { j["runs"][0]["element"].erase("name"); },
     "r.json:/runs/0/element: the member 'name' is missing"},
    {"MissingParameter", [](Json& j) { j["runs"][0]["parameters"].erase("edges"); },
     "r.json:/runs/0/parameters: the member 'edges' is missing"},
    {"AreaAsText", [](Json& j) { j["runs"][0]["parameters"]["dice_area_px"] = "1"; },
     "r.json:/runs/0/parameters/dice_area_px: \"1\" is not a number from 0.01 to 10000"},
    {"AreaTooLarge", [](Json& j) { j["runs"][0]["parameters"]["dice_area_px"] = 1e300; },
     "r.json:/runs/0/parameters/dice_area_px: 1e+300 is not a number from 0.01 to 10000"},
    {"ShortHash", [](Json& j) { j["runs"][0]["results_hash"] = "0x12"; },
     "r.json:/runs/0/results_hash: \"0x12\" is not a string of 0x and 16 hexadecimal digits, in "
     "small letters"},
    {"HashOfOtherLetters", [](Json& j) { j["runs"][0]["output"]["hash"] = "0x00000000000000zz"; },
     "r.json:/runs/0/output/hash: \"0x00000000000000zz\" is not a string of 0x and 16 hexadecimal "
     "digits, in small letters"},
    {"HashOfCapitals", [](Json& j) { j["runs"][0]["source"]["hash"] = "0x00000000000000AB"; },
     "r.json:/runs/0/source/hash: \"0x00000000000000AB\" is not a string of 0x and 16 hexadecimal "
     "digits, in small letters"},
    {"LanesMissing", [](Json& j) { j["runs"][0]["stages"][2]["lane_active"].erase(7); },
     "r.json:/runs/0/stages/2/lane_active: has 7 elements; 8 are needed"},
    {"NegativeCount", [](Json& j) { j["runs"][0]["stages"][0]["histogram"][3] = -4; },
     "r.json:/runs/0/stages/0/histogram/3: -4 is not an integer from 0 to 2^64 - 1"},
    {"EditedCount", [](Json& j) { j["runs"][0]["stages"][1]["instructions"][0]["active"] = 73; },
     "r.json:/runs/0/stages/1/utilization/numerator: 72 is not 73, which the counts give"},
    {"EditedHistogram", [](Json& j) { j["runs"][0]["stages"][1]["histogram"][0] = 1; },
     "r.json:/runs/0/stages/1/histogram: adds up to 11; 10 instructions were issued"},
    {"EditedLane", [](Json& j) { j["runs"][0]["stages"][1]["lane_active"][0] = 9; },
     "r.json:/runs/0/stages/1/lane_active: adds up to 71; 72 by the histogram"},
    {"OverheadAboveAll",
     [](Json& j) { j["runs"][0]["stages"][1]["instructions"][0]["overhead_issued"] = 11; },
     "r.json:/runs/0/stages/1/instructions/0/overhead_issued: 11 is not at most 10, which were "
     "issued"},
    {"OverheadLanesAboveAll",
     [](Json& j) { j["runs"][0]["stages"][1]["instructions"][0]["overhead_active"] = 73; },
     "r.json:/runs/0/stages/1/instructions/0/overhead_active: 73 is not at most 72, which were "
     "active"},
    {"MoreLanesThanThere",
     [](Json& j) { j["runs"][0]["stages"][1]["instructions"][0]["active"] = 81; },
     "r.json:/runs/0/stages/1/instructions/0/active: 81 is not at most 80, the lane slots of those "
     "issued"},
    {"OtherLanesThanCharged", [](Json& j) { j["instructions"][0]["charge"] = "one_lane"; },
     "r.json:/runs/0/stages/0/instructions/0/active: 16 is not 2, as each is charged one_lane"},
    {"FewerLanesThanCharged", [](Json& j) { j["instructions"][0]["charge"] = "all_lanes"; },
     "r.json:/runs/0/stages/1/instructions/0/active: 72 is not 80, as each is charged all_lanes"},
    {"MoreOverheadLanesThanThere",
     [](Json& j) { j["runs"][0]["stages"][1]["instructions"][0]["overhead_active"] = 1; },
     "r.json:/runs/0/stages/1/instructions/0/overhead_active: 1 is not at most 0, the lane slots "
     "of "
     "those issued"},
    {"StageTwice", [](Json& j) { j["runs"][0]["stages"][1]["name"] = "Setup"; },
     "r.json:/runs/0/stages/1/name: \"Setup\" is that of an earlier element, too; each has its "
     "own"},
    {"InstructionTwice",
     [](Json& j) { j["runs"][0]["stages"][3]["instructions"][1]["mnemonic"] = "add"; },
     "r.json:/runs/0/stages/3/instructions/1/mnemonic: \"add\" is that of an earlier element, too; "
     "each has its own"},
    {"MemoryTwice", [](Json& j) { j["runs"][0]["stages"][3]["memory"].push_back(memory_of(j)); },
     "r.json:/runs/0/stages/3/memory/1/mnemonic: \"scatter\" is that of an earlier element, too; "
     "each has its own"},
    {"GroupsOfNoInstruction", [](Json& j) { with_groups(j)["mnemonic"] = "gather"; },
     "r.json:/runs/0/stages/3/lane_groups/0/mnemonic: \"gather\" is not the mnemonic of an "
     "instruction of this stage"},
    {"GroupsOfMoreThanWereIssued", [](Json& j) { with_groups(j)["issued"] = 2; },
     "r.json:/runs/0/stages/3/lane_groups/0/issued: 2 is not at most 1, which were issued"},
    {"TooFewSizesOfGroups", [](Json& j) { with_groups(j)["dense_groups"].erase(0); },
     "r.json:/runs/0/stages/3/lane_groups/0/dense_groups: has 6 elements; 7 are needed"},
    {"MoreGroupsThanThereAre", [](Json& j) { with_groups(j)["active_groups"][3] = 2; },
     "r.json:/runs/0/stages/3/lane_groups/0/active_groups/3: 2 is not at most 1, the groups of "
     "those observed"},
    {"MoreDenseThanActiveGroups", [](Json& j) { with_groups(j)["dense_groups"][2] = 2; },
     "r.json:/runs/0/stages/3/lane_groups/0/dense_groups/2: 2 is not at most 1, the groups with a "
     "lane on"},
    {"OtherLanesInGroupsOfOne", [](Json& j) { with_groups(j)["dense_groups"][0] = 1; },
     "r.json:/runs/0/stages/3/lane_groups/0/dense_groups/0: 1 is not 2, the lanes that were on"},
    {"CountersThatDoNotAddUp",
     [](Json& j) {
       Json& counters = j["runs"][0]["counters"];
       counters.push_back(counters[1]);
       counters.back()["name"] = "micropolygons_degenerate";
     },
     "r.json:/runs/0/counters/0/value: 40 is not 60, which micropolygons_culled, "
     "micropolygons_degenerate and micropolygons_rasterized add up to"},
    {"CounterTwice", [](Json& j) { j["runs"][0]["counters"][4]["name"] = "tests"; },
     "r.json:/runs/0/counters/4/name: \"tests\" is that of an earlier element, too; each has its "
     "own"},
    {"CounterOfTheSourceTwice",
     [](Json& j) {
       Json& counters = j["runs"][0]["source"]["counters"];
       counters.push_back(counters[0]);
     },
     "r.json:/runs/0/source/counters/6/name: \"patches_culled\" is that of an earlier element, "
     "too; "
     "each has its own"},
    {"CounterOfTheOutputTwice",
     [](Json& j) {
       Json& counters = j["runs"][0]["output"]["counters"];
       counters.push_back(counters[0]);
     },
     "r.json:/runs/0/output/counters/1/name: \"samples_covered\" is that of an earlier element, "
     "too; each has its own"},
    {"MetricTwice",
     [](Json& j) { j["runs"][0]["metrics"].push_back(Json(j["runs"][0]["metrics"][0])); },
     "r.json:/runs/0/metrics/1/name: \"ste\" is that of an earlier element, too; each has its own"},
    {"SeriesTwice",
     [](Json& j) { j["runs"][0]["series"].push_back(Json(j["runs"][0]["series"][0])); },
     "r.json:/runs/0/series/1/name: \"box_candidates\" is that of an earlier element, too; each "
     "has "
     "its own"},
    {"CounterInCapitals", [](Json& j) { j["runs"][0]["counters"][3]["name"] = "Tests"; },
     "r.json:/runs/0/counters/3/name: \"Tests\" is not a name of small letters, digits and "
     "underscores that begins with a letter"},
    {"SeriesWithoutName", [](Json& j) { j["runs"][0]["series"][0]["name"] = ""; },
     "r.json:/runs/0/series/0/name: \"\" is not a name of small letters, digits and underscores "
     "that "
     "begins with a letter"},
    {"MetricFromADigit", [](Json& j) { j["runs"][0]["metrics"][0]["name"] = "1st"; },
     "r.json:/runs/0/metrics/0/name: \"1st\" is not a name of small letters, digits and "
     "underscores "
     "that begins with a letter"},
    {"EditedLines", [](Json& j) { memory_of(j)["lines"] = 2; },
     "r.json:/runs/0/stages/3/memory/0/lines: 2 is not 1, which the histogram gives"},
    {"EditedLinesHistogram", [](Json& j) { memory_of(j)["lines_histogram"][0] = 1; },
     "r.json:/runs/0/stages/3/memory/0/issued: 1 is not 2, which the histogram gives"},
    {"ShortLinesHistogram", [](Json& j) { memory_of(j)["lines_histogram"].erase(0); },
     "r.json:/runs/0/stages/3/memory/0/lines_histogram: has 8 elements; at least 9 are needed"},
    {"MemoryNotIssued", [](Json& j) { memory_of(j)["mnemonic"] = "gather"; },
     "r.json:/runs/0/stages/3/memory/0/mnemonic: \"gather\" is not the mnemonic of an instruction "
     "of this stage"},
    {"MoreObservedThanIssued",
     [](Json& j) {
       memory_of(j)["issued"] = 2;
       memory_of(j)["lines"] = 2;
       memory_of(j)["lines_histogram"][1] = 2;
     },
     "r.json:/runs/0/stages/3/memory/0/issued: 2 is not at most 1, which were issued"},
    {"MoreConflictsThanLanes", [](Json& j) { memory_of(j)["conflicts"] = 3; },
     "r.json:/runs/0/stages/3/memory/0/conflicts: 3 is not at most 2, which were active"},
    {"MoreLanesObservedThanThere",
     [](Json& j) {
       j["runs"][0]["stages"][3]["instructions"][1]["active"] = 1;
       j["runs"][0]["stages"][3]["utilization"] = {
           {"numerator", 59}, {"denominator", 240}, {"value", 59.0 / 240.0}};
       j["instructions"][1]["charge"] = "one_lane";
       memory_of(j)["active"] = 9;
     },
     "r.json:/runs/0/stages/3/memory/0/active: 9 is not at most 8, the lane slots of those "
     "observed"},
    {"MoreLanesObservedThanActive", [](Json& j) { memory_of(j)["active"] = 3; },
     "r.json:/runs/0/stages/3/memory/0/active: 3 is not at most 2, which were active"},
    {"MorePiecesObservedThanThere", [](Json& j) { j["runs"][0]["source"]["pieces_observed"] = 4; },
     "r.json:/runs/0/source/pieces_observed: 4 is not at most 3, the pieces"},
    {"LineOfOtherStage", [](Json& j) { j["runs"][0]["source_lines"][0]["stage"] = "Stup"; },
     "r.json:/runs/0/source_lines/0/stage: \"Stup\" is not the name of a stage of this run"},
    {"LinesAboveTheStage", [](Json& j) { j["runs"][0]["source_lines"][3]["issued"] = 31; },
     "r.json:/runs/0/source_lines/3/issued: 31 is not at most 30, which the stage issued"},
    {"LanesOfLinesAboveTheStage", [](Json& j) { j["runs"][0]["source_lines"][3]["active"] = 61; },
     "r.json:/runs/0/source_lines/3/active: 61 is not at most 60, which were active in the stage"},
    {"LineBeyondAllFiles",
     [](Json& j) { j["runs"][0]["source_lines"][0]["line"] = std::uint64_t{1} << 31; },
     "r.json:/runs/0/source_lines/0/line: 2147483648 is not an integer of at least 1"},
    {"BlockFromZero", [](Json& j) { j["runs"][0]["source_lines"][0]["block"]["line"] = 0; },
     "r.json:/runs/0/source_lines/0/block/line: 0 is not an integer of at least 1"},
    {"LineFromZero", [](Json& j) { j["runs"][0]["source_lines"][0]["line"] = 0; },
     "r.json:/runs/0/source_lines/0/line: 0 is not an integer of at least 1"},
    {"SeriesOfText", [](Json& j) { j["runs"][0]["series"][0]["values"][1] = "3"; },
     "r.json:/runs/0/series/0/values/1: \"3\" is not an integer from 0 to 2^64 - 1"},
    {"OtherMachine", [](Json& j) { j["machine"]["line_bytes"] = 32; },
     "r.json:/machine/line_bytes: 32 is not 64"},
    {"OtherElements", [](Json& j) { j["machine"]["element_types"][1] = "int16"; },
     "r.json:/machine/element_types/1: \"int16\" is not \"int32\""},
    {"FewerElements", [](Json& j) { j["machine"]["element_types"].erase(2); },
     "r.json:/machine/element_types: has 2 elements; 3 are needed"},
    {"CommitAsNumber", [](Json& j) { j["made_by"]["commit"] = 5; },
     "r.json:/made_by/commit: 5 is not a string"},
    {"EmptyCommit", [](Json& j) { j["made_by"]["commit"] = ""; },
     "r.json:/made_by/commit: \"\" is not a commit, or null if it is not known"},
    {"OtherClass", [](Json& j) { j["instructions"][0]["class"] = "arithmetics"; },
     "r.json:/instructions/0/class: \"arithmetics\" is not arithmetic, integer, compare, convert, "
     "move, mask, memory, reduce, scan or special; did you mean 'arithmetic'?"},
    {"OtherCharge", [](Json& j) { j["instructions"][1]["charge"] = "no_lane"; },
     "r.json:/instructions/1/charge: \"no_lane\" is not active_lanes, all_lanes or one_lane; did "
     "you "
     "mean 'one_lane'?"},
    {"ExplainedButNotIssued",
     [](Json& j) {
       j["instructions"].push_back(j["instructions"][0]);
       j["instructions"].back()["mnemonic"] = "zoom";
     },
     "r.json:/instructions/2/mnemonic: \"zoom\" is not the mnemonic of an instruction that some "
     "run issued"},
    {"RunTwice",
     [](Json& j) {
       j["runs"].push_back(Json(j["runs"][1]));
       j["timing"]["kernel_ms"].push_back(1);
     },
     "r.json:/runs/12/parameters: are those of an earlier run, too; each run has its own"},
    {"ExplainedTwice", [](Json& j) { j["instructions"][1]["mnemonic"] = "add"; },
     "r.json:/instructions/1/mnemonic: \"add\" is that of an earlier element, too; each has its "
     "own"},
    {"NegativeTime", [](Json& j) { j["timing"]["wall_ms"] = -0.5; },
     "r.json:/timing/wall_ms: -0.5 is not a number of at least 0"},
    {"NegativeTimeOfARun", [](Json& j) { j["timing"]["kernel_ms"][2] = -1; },
     "r.json:/timing/kernel_ms/2: -1 is not a number of at least 0"},
    {"NegativeTimeOfTheSource", [](Json& j) { j["timing"]["source_ms"] = -1e-9; },
     "r.json:/timing/source_ms: -1e-09 is not a number of at least 0"},
    {"NegativeTimeOfObserving", [](Json& j) { j["timing"]["observation_ms"] = -2; },
     "r.json:/timing/observation_ms: -2 is not a number of at least 0"},
    {"NoThreads", [](Json& j) { j["timing"]["threads"] = 0; },
     "r.json:/timing/threads: 0 is not an integer of at least 1"},
    {"NegativeMemory", [](Json& j) { j["timing"]["peak_memory_bytes"] = -1; },
     "r.json:/timing/peak_memory_bytes: -1 is not an integer from 0 to 2^64 - 1"},
    {"EditedValue", [](Json& j) { j["runs"][0]["stages"][1]["utilization"]["value"] = 0.95; },
     "r.json:/runs/0/stages/1/utilization/value: 0.95 is not 0.9, the numerator over the "
     "denominator"},
    {"ValueAsNull", [](Json& j) { j["runs"][0]["stages"][1]["utilization"]["value"] = nullptr; },
     "r.json:/runs/0/stages/1/utilization/value: null is not a number"},
    {"OtherCounter", [](Json& j) { j["runs"][0]["metrics"][0]["numerator_counter"] = "hit"; },
     "r.json:/runs/0/metrics/0/numerator_counter: \"hit\" is not the name of a counter of this "
     "run"},
    {"UnexplainedInstruction", [](Json& j) { j["instructions"].erase(0); },
     "r.json:/runs/0/stages/0/instructions/0/mnemonic: \"add\" is not the mnemonic of one of "
     "/instructions"},
    {"TimeMissing", [](Json& j) { j["timing"]["kernel_ms"].erase(0); },
     "r.json:/timing/kernel_ms: has 11 elements; 12 are needed, one for each run"},
    {"LongText",
     [](Json& j) { j["runs"][0]["parameters"]["micropolygon"] = std::string(200, 'x'); },
     "r.json:/runs/0/parameters/micropolygon: \"" + std::string(59, 'x') +
         "... is not triangle or quad"},
};

INSTANTIATE_TEST_SUITE_P(Spoilt, BadReports, ::testing::ValuesIn(kBadReports),
                         [](const auto& info) { return std::string(info.param.name); });

std::string complaint(const std::string& text) {
  try {
    parse_report(text, "r.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "was read";
}

TEST(BadJson, NamesLineAndColumn) {
  EXPECT_EQ(complaint("").substr(0, 27), "r.json:1:1: is not JSON: sy");
  EXPECT_EQ(complaint("{\n  \"schema\": x\n}").substr(0, 26), "r.json:2:13: is not JSON: ");
}

TEST(BadJson, TruncatedAnywhereIsRefused) {
  const std::string text = report_text(testing::sample_report());
  for (std::size_t length = 0; length + 1 < text.size(); length += 997)
    EXPECT_EQ(complaint(text.substr(0, length)).rfind("r.json:", 0), 0u) << length;
}

TEST(BadJson, TwiceTheSameMemberIsRefused) {
  EXPECT_EQ(complaint(R"({"schema": 1, "schema": 2})"),
            "r.json: an object has the member 'schema' twice");
}

TEST(BadJson, NumbersThatNothingHoldsAreRefusedWithTheirPlace) {
  EXPECT_EQ(complaint("[1e999]"), "r.json:1:2: 1e999 is not a number up to 1.8e308");
  EXPECT_EQ(complaint("{\"-1e999 \\\" -1e999\":\n  -1e999}"),
            "r.json:2:3: -1e999 is not a number up to 1.8e308");
}

TEST(BadJson, CountsBeyond64BitsAreRefused) {
  std::string text = report_text(testing::sample_report());
  const std::string pieces = "\"pieces\": 3";
  const std::size_t place = text.find(pieces);
  ASSERT_NE(place, text.npos);
  text.replace(place, pieces.size(), "\"pieces\": 18446744073709551616");
  EXPECT_EQ(complaint(text),
            "r.json:/runs/0/source/pieces: 1.8446744073709552e+19 is not an integer from 0 to "
            "2^64 - 1");
}

TEST(BadJson, MissingFileIsNamed) {
  try {
    read_report("/nonexistent/report.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "/nonexistent/report.json: cannot be read: No such file or directory");
  }
}

}  // namespace
}  // namespace lanescope
