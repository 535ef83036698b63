// SPDX-License-Identifier: MIT
#include "analysis/report/report_json.h"

#include <gtest/gtest.h>

#include "analysis/base/json_text.h"
#include "analysis/formats/format.h"
#include "analysis/tables/table.h"
#include "simulator/base/error.h"
#include "simulator/instruction_set.h"
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
  RunRecord& run = report.runs[1];
  const auto set = [&](std::string_view name, Value value) {
    ASSERT_NE(value_of(run.configuration, name), value) << name << " is so by default";
    set_value(run.configuration, name, std::move(value));
  };
  set("turn_degrees", 0.1f);
  set("mesh_patches", std::string("phong"));
  set("frame", std::uint64_t{7});
  set("seed", std::uint64_t{0xfedcba9876543210});
  set("mode", std::string("checked"));
  set("edges", std::string("precomputed"));
  set("cull_backfaces", false);
  set("stream_load_threshold", 0.3f);
  set("dice_area_px", 0.7f);
  set("grid_overlap_px", 0.2f);
  set("observe_every", std::uint64_t{0});
  run.counters.front().value = 0xffffffffffffffff;
  const std::string text = report_text(report);
  const Report read = parse_report(text, "report.json");
  EXPECT_EQ(report_text(read), text);
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    EXPECT_EQ(read.runs[i].configuration, report.runs[i].configuration) << i;
  EXPECT_EQ(value_of(read.runs[1].configuration, "turn_degrees"), Value(0.1f));
  EXPECT_EQ(all_tables(read), all_tables(report));
}

/// So that the round trip is one of every member.
TEST(ReportJson, TheSampleHasEveryMember) {
  const Json json = to_json(testing::sample_report());
  const Json& run = json["runs"][0];
  for (const auto& [name, value] : run.items()) EXPECT_FALSE(value.empty()) << name;
  for (const char* member : {"source", "element", "output"})
    for (const auto& [name, value] : run[member].items()) EXPECT_FALSE(value.empty()) << name;
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
  EXPECT_EQ(run["source"]["hash"], "0x0123456789abcdef");
}

TEST(ReportJson, ARunHasItsMembersInOrder) {
  const Json json = to_json(testing::sample_report());
  std::vector<std::string> names;
  for (const auto& [name, value] : json["runs"][0].items()) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"parameters", "workload", "source", "element",
                                             "stages", "counters", "metrics", "series",
                                             "source_lines", "results_hash", "output"}));
  EXPECT_EQ(json["runs"][0]["element"].dump(),
            R"({"counter":"micropolygons_rasterized","name":"micropolygon","abbreviation":"mp"})");
}

TEST(ReportJson, AKernelHasItsOwnParametersOnly) {
  const Json json = to_json(testing::sample_report());
  EXPECT_FALSE(json["runs"][0]["parameters"].contains("stream_load_threshold"));
  EXPECT_TRUE(json["runs"][1]["parameters"].contains("stream_load_threshold"));
}

/// A report outlives the program that made it, and its kernels.
TEST(ReportJson, AKernelThatTheProgramDoesNotHaveIsRead) {
  Report report = testing::sample_report();
  RunRecord& run = report.runs[0];
  run.configuration.kernel = "another";
  run.workload = "things";
  run.configuration.arguments = {};
  run.configuration.arguments.set("depth", std::uint64_t{3});
  run.configuration.arguments.set("share", 0.3f);
  run.configuration.arguments.set("order", std::string("random"));
  run.configuration.arguments.set("exact", true);
  run.configuration.arguments.set("limit", {});
  const Report read = parse_report(report_text(report), "r");
  EXPECT_EQ(report_text(read), report_text(report));
  EXPECT_EQ(read.runs[0].configuration, run.configuration);
}

TEST(ReportJson, AKernelWithoutCountersNeedsNone) {
  Report report = testing::sample_report();
  report.runs[0].counters.clear();
  report.runs[0].metrics.clear();
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));
}

/// Earlier programs did not say in which block a line was issued.
TEST(ReportJson, ALineOfSourceMayLackItsBlock) {
  Report report = testing::sample_report();
  report.runs[0].source_lines[0].block.reset();
  const Report read = parse_report(report_text(report), "r");
  EXPECT_FALSE(read.runs[0].source_lines[0].block);
  EXPECT_EQ(read.runs[0].source_lines[1].block, (SourcePlace{"kernels/sample.h", 5}));
  EXPECT_EQ(report_text(read), report_text(report));
}

/// Makes the scatter of the first run one of that charge, which Process issues once.
MemoryRecord& charge_scatter(Report& report, Charge charge, std::uint64_t lanes) {
  report.instructions[1].charge = to_string(charge);
  for (RunRecord& run : report.runs)
    for (StageRecord& stage : run.stages)
      for (InstructionRecord& counts : stage.instructions)
        if (counts.mnemonic == "scatter") counts.active = lanes;
  return report.runs[0].stages[3].memory[0];
}

/// What is charged does not bound the lanes that were seen on.
TEST(ReportJson, MemoryInstructionsMayBeChargedAnything) {
  Report report = testing::sample_report();
  MemoryRecord& one = charge_scatter(report, Charge::kOneLane, 1);
  one.active = 8;
  one.conflicts = 7;
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));

  report = testing::sample_report();
  MemoryRecord& all = charge_scatter(report, Charge::kAllLanes, 8);
  all.active = 0;
  all.conflicts = 7;
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));
}

TEST(ReportJson, AnExecutionMayTouchMoreLinesThanLanes) {
  Report report = testing::sample_report();
  MemoryRecord& memory = report.runs[0].stages[3].memory[0];
  memory.lines_histogram.assign(17, 0);
  memory.lines_histogram[16] = 1;
  memory.lines = 16;
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));
}

TEST(ReportJson, EveryInstructionOfTheSetIsRead) {
  Report report = testing::sample_report();
  StageRecord& stage = report.runs[0].stages[0];
  for (const InstructionInfo* info : instruction_set()) {
    if (info->mnemonic == "add" || info->mnemonic == "scatter") continue;
    report.instructions.push_back({std::string(info->mnemonic), std::string(info->meaning),
                                   std::string(to_string(info->instruction_class)),
                                   std::string(to_string(info->charge))});
    // Once, with no lane on.
    stage.instructions.push_back(
        {std::string(info->mnemonic), 1,
         charged_lanes(info->charge, 1, 0, report.runs[0].configuration.width)});
    stage.histogram[0] += 1;
  }
  EXPECT_EQ(report_text(parse_report(report_text(report), "r")), report_text(report));
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

TEST(ReportJsonSchema, HasTheParametersOfEveryKernel) {
  const Json schema = Json::parse(report_json_schema());
  const Json& parameters = schema["$defs"]["parameters"];
  EXPECT_EQ(parameters["allOf"].size(), kernels().size());
  for (std::size_t i = 0; i < kernels().size(); ++i) {
    const Json& own = parameters["allOf"][i]["then"]["properties"];
    EXPECT_EQ(own["kernel"]["const"], kernels()[i]->name);
    for (const Parameter& parameter : parameters_of(*kernels()[i]))
      EXPECT_TRUE(own.contains(std::string(parameter.name()))) << parameter.name();
  }
}

TEST(ReportJsonSchema, HasTheWordsOfTheInstructionSet) {
  const Json properties = Json::parse(report_json_schema())["$defs"]["instruction"]["properties"];
  Json classes = Json::array(), charges = Json::array();
  for (const InstructionClass one : kInstructionClasses) classes.push_back(to_string(one));
  for (const Charge one : kCharges) charges.push_back(to_string(one));
  EXPECT_EQ(properties["class"]["enum"], classes);
  EXPECT_EQ(properties["charge"]["enum"], charges);
}

TEST(ReportJsonSchema, IsOfTheVersionThatIsWritten) {
  const Json schema = Json::parse(report_json_schema());
  EXPECT_EQ(schema["properties"]["schema"]["properties"]["version"]["const"], kReportVersion);
  EXPECT_EQ(schema["$id"], fmt::format("urn:lanescope:report:{}", kReportVersion));
}

}  // namespace
}  // namespace lanescope
