// SPDX-License-Identifier: MIT
#include "analysis/report_json.h"

#include <gtest/gtest.h>

#include "analysis/format.h"
#include "analysis/json_text.h"
#include "analysis/table.h"
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
  report.runs.front().stages.front().instructions.front().issued = 0xffffffff;
  const std::string text = report_text(report);
  const Report read = parse_report(text, "report.json");
  EXPECT_EQ(report_text(read), text);
  EXPECT_EQ(read.runs.front().configuration.turn_degrees, 0.1f);
  EXPECT_EQ(all_tables(read), all_tables(report));
}

TEST(ReportJson, CountsAreIntegersAndRatiosKeepTheirParts) {
  const Json json = to_json(testing::sample_report());
  const Json& run = json["runs"][0];
  EXPECT_EQ(run["stages"][1]["utilization"].dump(),
            R"({"numerator":72,"denominator":80,"value":0.9})");
  EXPECT_EQ(run["metrics"][0]["ratio"].dump(), R"({"numerator":40,"denominator":200,"value":0.2})");
  EXPECT_EQ(run["scene"]["hash"], "0x0123456789abcdef");
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

const std::vector<BadReport> kBadReports{
    {"NotAnObject", [](Json& j) { j = Json::array(); }, "r.json:/: an array is not an object"},
    {"NoSchema", [](Json& j) { j.erase("schema"); }, "r.json:/: the member 'schema' is missing"},
    {"OtherSchema", [](Json& j) { j["schema"]["name"] = "other"; },
     "r.json:/schema/name: \"other\" is not \"lanescope-report\""},
    {"NewerVersion", [](Json& j) { j["schema"]["version"] = 2; },
     "r.json:/schema/version: version 2 is newer than 1, the newest that this program reads"},
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
    {"KernelAsNumber", [](Json& j) { j["runs"][0]["kernel"] = 5; },
     "r.json:/runs/0/kernel: 5 is not a string"},
    {"WidthTooLarge", [](Json& j) { j["runs"][0]["width_lanes"] = 65; },
     "r.json:/runs/0/width_lanes: 65 is not an integer from 1 to 64"},
    {"WidthAsFraction", [](Json& j) { j["runs"][0]["width_lanes"] = 8.5; },
     "r.json:/runs/0/width_lanes: 8.5 is not an integer from 1 to 64"},
    {"HugeInteger", [](Json& j) { j["runs"][0]["width_lanes"] = 0xffffffffffffffff; },
     "r.json:/runs/0/width_lanes: 18446744073709551615 is not an integer from 1 to 64"},
    {"OtherShape", [](Json& j) { j["runs"][0]["micropolygon"] = "pentagon"; },
     "r.json:/runs/0/micropolygon: \"pentagon\" is not triangle or quad"},
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
    {"EditedValue", [](Json& j) { j["runs"][0]["stages"][1]["utilization"]["value"] = 0.95; },
     "r.json:/runs/0/stages/1/utilization/value: 0.95 is not 0.9, the numerator over the "
     "denominator"},
    {"ValueAsNull", [](Json& j) { j["runs"][0]["stages"][1]["utilization"]["value"] = nullptr; },
     "r.json:/runs/0/stages/1/utilization/value: null is not a number"},
    {"OtherCounter", [](Json& j) { j["runs"][0]["metrics"][0]["numerator_counter"] = "hit"; },
     "r.json:/runs/0/metrics/0/numerator_counter: \"hit\" is not the name of a counter of this "
     "run"},
    {"UnexplainedInstruction", [](Json& j) { j["instructions"] = Json::array(); },
     "r.json:/runs/0: the instruction 'add' is not among /instructions"},
    {"TimeMissing", [](Json& j) { j["timing"]["kernel_ms"].erase(0); },
     "r.json:/timing/kernel_ms: has 11 elements; 12 are needed, one for each run"},
    {"LongText", [](Json& j) { j["runs"][0]["micropolygon"] = std::string(200, 'x'); },
     "r.json:/runs/0/micropolygon: \"" + std::string(59, 'x') + "... is not triangle or quad"},
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
