// SPDX-License-Identifier: MIT
#include "analysis/report/report_json.h"

#include <gtest/gtest.h>

#include "analysis/base/json_text.h"
#include "analysis/formats/format.h"
#include "analysis/tables/table.h"
#include "simulator/base/error.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

std::string all_tables(const Report& report) {
  std::vector<TableData> data;
  for (const Table* table : tables()) data.push_back(build_table(*table, ReportView(report)));
  return find_format("text").write(data);
}

TEST(ReportJson, RoundTripKeepsEverything) {
  Report report = testing::sample_report();
  Configuration& c = report.runs.front().configuration;
  c.turn_degrees = 0.1f;
  c.mesh_patches = MeshPatches::kPhong;
  c.frame = 7;
  c.seed = 0xfedcba9876543210;
  c.mode = Mode::kChecked;
  c.options.edges = Edges::kPrecomputed;
  c.options.cull_backfaces = false;
  c.options.stream_load_threshold = 0.3f;
  c.tessellation.dice_area_px = 0.7f;
  c.tessellation.grid_overlap_px = 0.2f;
  c.observe_every = 0;
  report.runs.front().counters.front().value = 0xffffffffffffffff;
  const std::string text = report_text(report);
  const Report read = parse_report(text, "report.json");
  EXPECT_EQ(report_text(read), text);
  EXPECT_EQ(read.runs.front().configuration.turn_degrees, 0.1f);
  EXPECT_EQ(all_tables(read), all_tables(report));
}

/// So that the round trip is one of every member.
TEST(ReportJson, TheSampleHasEveryMember) {
  const Json json = to_json(testing::sample_report());
  const Json& run = json["runs"][0];
  for (const auto& [name, value] : run.items()) EXPECT_FALSE(value.empty()) << name;
  for (const auto& [name, value] : run["stages"][3].items()) EXPECT_FALSE(value.empty()) << name;
  for (const auto& [name, value] : json["timing"].items()) EXPECT_NE(value, 0) << name;
  EXPECT_EQ(json["made_by"]["commit"], "0123456789ab");
}

TEST(ReportJson, AnUnknownCommitIsNull) {
  Report report = testing::sample_report();
  report.commit.clear();
  EXPECT_TRUE(to_json(report)["made_by"]["commit"].is_null());
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));
}

TEST(ReportJson, CountsAreIntegersAndRatiosKeepTheirParts) {
  const Json json = to_json(testing::sample_report());
  const Json& run = json["runs"][0];
  EXPECT_EQ(run["stages"][1]["utilization"].dump(),
            R"({"numerator":72,"denominator":80,"value":0.9})");
  EXPECT_EQ(run["metrics"][0]["ratio"].dump(), R"({"numerator":40,"denominator":200,"value":0.2})");
  EXPECT_EQ(run["scene_hash"], "0x0123456789abcdef");
}

TEST(ReportJson, UndefinedRatiosAreNull) {
  Report report = testing::sample_report();
  for (CounterRecord& counter : report.runs[0].counters) counter.value = 0;
  EXPECT_TRUE(to_json(report)["runs"][0]["metrics"][0]["ratio"]["value"].is_null());
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));
}

TEST(ReportJson, FloatsAreWrittenShortest) {
  EXPECT_EQ(Json(json_number(0.1f)).dump(), "0.1");
  EXPECT_EQ(Json(json_number(1.0f)).dump(), "1.0");
}

TEST(JsonText, KeepsListsOfNumbersOnALine) {
  EXPECT_EQ(json_text({{"a", {1, 2, 3}}, {"b", {{"c", Json::array({Json::array({1})})}}}}),
            "{\n  \"a\": [1, 2, 3],\n  \"b\": {\n    \"c\": [\n      [1]\n    ]\n  }\n}\n");
  EXPECT_EQ(json_text(Json::array()), "[]\n");
  const Json odd = {{"quo\"te", "new\nline"}};
  EXPECT_EQ(Json::parse(json_text(odd)), odd);
}

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

const std::vector<BadReport> kBadReports{
    {"NotAnObject", [](Json& j) { j = Json::array(); }, "r.json:/: an array is not an object"},
    {"NoSchema", [](Json& j) { j.erase("schema"); }, "r.json:/: the member 'schema' is missing"},
    {"OtherSchema", [](Json& j) { j["schema"]["name"] = "other"; },
     "r.json:/schema/name: \"other\" is not \"lanescope-report\""},
    {"NewerVersion", [](Json& j) { j["schema"]["version"] = 3; },
     "r.json:/schema/version: version 3 is newer than 2, the newest that this program reads"},
    {"OlderVersion", [](Json& j) { j["schema"]["version"] = 1; },
     "r.json:/schema/version: version 1 is older than 2, the only one that this program reads"},
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
     "r.json:/runs/0/parameters/seed: -1 is not an integer of at least 0"},
    {"MissingParameter", [](Json& j) { j["runs"][0]["parameters"].erase("edges"); },
     "r.json:/runs/0/parameters: the member 'edges' is missing"},
    {"AreaAsText", [](Json& j) { j["runs"][0]["parameters"]["dice_area_px"] = "1"; },
     "r.json:/runs/0/parameters/dice_area_px: \"1\" is not a number"},
    {"AreaTooLarge", [](Json& j) { j["runs"][0]["parameters"]["dice_area_px"] = 1e300; },
     "r.json:/runs/0/parameters/dice_area_px: 1e+300 is not a number in the range of single "
     "precision"},
    {"ShortHash", [](Json& j) { j["runs"][0]["hits_hash"] = "0x12"; },
     "r.json:/runs/0/hits_hash: \"0x12\" is not a string of 0x and 16 hexadecimal digits"},
    {"HashOfOtherLetters", [](Json& j) { j["runs"][0]["frame_hash"] = "0x00000000000000zz"; },
     "r.json:/runs/0/frame_hash: \"0x00000000000000zz\" is not a string of 0x and 16 hexadecimal "
     "digits"},
    {"LanesMissing", [](Json& j) { j["runs"][0]["stages"][2]["lane_active"].erase(7); },
     "r.json:/runs/0/stages/2/lane_active: has 7 elements; 8 are needed"},
    {"NegativeCount", [](Json& j) { j["runs"][0]["stages"][0]["histogram"][3] = -4; },
     "r.json:/runs/0/stages/0/histogram/3: -4 is not an integer of at least 0"},
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
    {"EditedLines", [](Json& j) { memory_of(j)["lines"] = 2; },
     "r.json:/runs/0/stages/3/memory/0/lines: 2 is not 1, which the histogram gives"},
    {"EditedLinesHistogram", [](Json& j) { memory_of(j)["lines_histogram"][0] = 1; },
     "r.json:/runs/0/stages/3/memory/0/issued: 1 is not 2, which the histogram gives"},
    {"ShortLinesHistogram", [](Json& j) { memory_of(j)["lines_histogram"].erase(0); },
     "r.json:/runs/0/stages/3/memory/0/lines_histogram: has 8 elements; 9 are needed"},
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
    {"MorePacketsObservedThanThere",
     [](Json& j) { j["runs"][0]["observation"]["packets_observed"] = 4; },
     "r.json:/runs/0/observation/packets_observed: 4 is not at most 3, the packets"},
    {"LineOfOtherStage", [](Json& j) { j["runs"][0]["source_lines"][0]["stage"] = "Stup"; },
     "r.json:/runs/0/source_lines/0/stage: \"Stup\" is not the name of a stage of this run"},
    {"LinesAboveTheStage", [](Json& j) { j["runs"][0]["source_lines"][3]["issued"] = 31; },
     "r.json:/runs/0/source_lines/3/issued: 31 is not at most 30, which the stage issued"},
    {"LineFromZero", [](Json& j) { j["runs"][0]["source_lines"][0]["line"] = 0; },
     "r.json:/runs/0/source_lines/0/line: 0 is not an integer of at least 1"},
    {"SeriesOfText", [](Json& j) { j["runs"][0]["series"][0]["values"][1] = "3"; },
     "r.json:/runs/0/series/0/values/1: \"3\" is not an integer of at least 0"},
    {"OtherMachine", [](Json& j) { j["machine"]["line_bytes"] = 32; },
     "r.json:/machine/line_bytes: 32 is not 64"},
    {"OtherElements", [](Json& j) { j["machine"]["element_types"][1] = "int16"; },
     "r.json:/machine/element_types/1: \"int16\" is not \"int32\""},
    {"FewerElements", [](Json& j) { j["machine"]["element_types"].erase(2); },
     "r.json:/machine/element_types: has 2 elements; 3 are needed"},
    {"CommitAsNumber", [](Json& j) { j["made_by"]["commit"] = 5; },
     "r.json:/made_by/commit: 5 is not a string"},
    {"NegativeMemory", [](Json& j) { j["timing"]["peak_memory_bytes"] = -1; },
     "r.json:/timing/peak_memory_bytes: -1 is not an integer of at least 0"},
    {"EditedValue", [](Json& j) { j["runs"][0]["stages"][1]["utilization"]["value"] = 0.95; },
     "r.json:/runs/0/stages/1/utilization/value: 0.95 is not 0.9, the numerator over the "
     "denominator"},
    {"ValueAsNull", [](Json& j) { j["runs"][0]["stages"][1]["utilization"]["value"] = nullptr; },
     "r.json:/runs/0/stages/1/utilization/value: null is not a number"},
    {"OtherCounter", [](Json& j) { j["runs"][0]["metrics"][0]["numerator_counter"] = "hit"; },
     "r.json:/runs/0/metrics/0/numerator_counter: \"hit\" is not the name of a counter of this "
     "run"},
    {"UnexplainedInstruction", [](Json& j) { j["instructions"].erase(0); },
     "r.json:/runs/0: the instruction 'add' is not among /instructions"},
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

TEST(BadJson, NumbersThatNothingHoldsAreRefused) {
  EXPECT_EQ(complaint("[1e999]").rfind("r.json: has a number too large for a double: ", 0), 0u);
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
