// SPDX-License-Identifier: MIT
// `lanescope machines` and `lanescope crossover`, and the JSON Schema of machines.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/machines/description.h"
#include "analysis/machines/shipped_text.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;
using testing::Outcome;

class Machines : public testing::InEmptyDirectory {
 protected:
  Machines() {
    run("run --scene teapot --resolution 96x60 --kernel lockstep,repack --width 8,16 --json "
        "r.json");
  }

  Json json_of(const std::string& command) const { return Json::parse(run(command).output); }

  Outcome validate(const std::string& files) const {
    return testing::shell(
        "/usr/bin/python3 '" LANESCOPE_SOURCE_DIR "/tests/schema/validate.py' schema.json " + files,
        directory());
  }
};

TEST_F(Machines, TakeTheCountsOfTheReportWhereEveryInstructionIsOne) {
  const Json report = Json::parse(file("r.json"));
  const Json machine = json_of("machines r.json --machine thesis --format json")["machines"][0];
  ASSERT_EQ(machine["runs"].size(), report["runs"].size());
  for (std::size_t i = 0; i < report["runs"].size(); ++i)
    for (std::size_t s = 0; s < report["runs"][i]["stages"].size(); ++s) {
      const Json& stage = report["runs"][i]["stages"][s];
      const Json& cost = machine["runs"][i]["stages"][s];
      EXPECT_EQ(cost["name"], stage["name"]);
      double issued = 0;
      for (const Json& counts : stage["instructions"]) issued += counts["issued"].get<double>();
      EXPECT_DOUBLE_EQ(cost["slots"].get<double>(), issued);
      EXPECT_NEAR(cost["utilization"].get<double>(), stage["utilization"]["value"].get<double>(),
                  1e-12);
    }
}

TEST_F(Machines, AreShownInEveryFormat) {
  const std::string text = run("machines r.json --machine avx2").output;
  EXPECT_NE(text.find("Issue slots for each element on avx2 (utilization)"), std::string::npos);
  EXPECT_NE(text.find("machine = avx2 (8 lanes, 0x"), std::string::npos);
  EXPECT_NE(text.find("Slots/mp, all stages"), std::string::npos) << text;
  EXPECT_NE(run("machines r.json --format markdown").output.find("| Stage |"), std::string::npos);
  EXPECT_EQ(run("machines r.json --format csv").output.rfind("table,scenes,", 0), 0u);
  for (const MachineDescription& machine : shipped_machines())
    EXPECT_NE(run("machines r.json").output.find("on " + machine.name + " ("), std::string::npos);
}

TEST_F(Machines, SayWhatIsMissing) {
  write("m.json", R"({"name": "m", "summary": "m", "inherits": "avx2",
                      "instructions": {"mul": "unknown"}})");
  const std::string text = run("machines r.json --machine m.json").output;
  EXPECT_NE(text.find("n/a"), std::string::npos);
  EXPECT_NE(text.find("There are no totals on m where it is not known what this takes: mul"),
            std::string::npos)
      << text;
  EXPECT_NE(run("machines r.json --machine m.json --format csv")
                .output.find("Not known,W = 8,words,,,,,mul"),
            std::string::npos);
  const Json json = json_of("machines r.json --machine m.json --format json");
  EXPECT_TRUE(json["machines"][0]["runs"][0]["slots"].is_null());
}

TEST_F(Machines, CrossWhereTheSlotsOfBothAreTheSame) {
  const Json json =
      json_of("crossover --from r.json --machine thesis --kernels repack,lockstep --format json");
  ASSERT_EQ(json["crossovers"].size(), 1u);
  const Json& one = json["crossovers"][0];
  EXPECT_EQ(one["first"], "repack");
  EXPECT_EQ(one["second"], "lockstep");
  EXPECT_EQ(one["facet"], "triangle");
  ASSERT_EQ(one["widths"].size(), 2u);
  const Json other = json_of("crossover --from r.json --machine thesis --format json");
  EXPECT_NEAR(one["widths"][0]["ratio"].get<double>() *
                  other["crossovers"][0]["widths"][0]["ratio"].get<double>(),
              1.0, 1e-12);
  EXPECT_FALSE(one["sensitivities"].empty());
}

TEST_F(Machines, RunTheExperimentOfACrossover) {
  const std::string text = run("crossover --scene teapot --resolution 48x30 --width 8,16 "
                               "--stream-load-threshold 0,0.5 --machine neon")
                               .output;
  EXPECT_NE(text.find("stream_load_threshold = 0"), std::string::npos) << text;
  EXPECT_NE(text.find("stream_load_threshold = 0.5"), std::string::npos) << text;
  EXPECT_NE(text.find("neon"), std::string::npos);
}

TEST_F(Machines, OfOneKernelDoNotCross) {
  run("run --scene teapot --resolution 48x30 --kernel lockstep --width 8 --json one.json");
  const Outcome outcome = run("crossover --from one.json", 2);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.errors,
            "lanescope: one.json: has one kernel that counted instructions; two are needed\n");
}

TEST_F(Machines, FollowTheirSchema) {
  write("schema.json", run("schema machine").output);
  std::string files;
  for (const ShippedText& shipped : shipped_texts()) {
    const std::string name = std::to_string(files.size()) + ".json";
    write(name, shipped.text);
    files += name + " ";
  }
  const Outcome good = validate(files);
  EXPECT_EQ(good.status, 0) << good.output << good.errors;
  const Json base = Json::parse(shipped_texts().front().text);
  const std::vector<void (*)(Json&)> spoilers{
      [](Json& j) { j.erase("summary"); },
      [](Json& j) { j["speed"] = 1; },
      [](Json& j) { j["lanes"] = 12; },
      [](Json& j) { j["classes"]["arithmetics"] = "unknown"; },
      [](Json& j) { j["classes"]["move"]["slots"]["lanes"] = 1; },
      [](Json& j) { j["classes"]["move"]["slots"]["lane"] = -1; },
      [](Json& j) { j["classes"]["move"].erase("source"); },
      [](Json& j) { j["classes"]["move"] = "none"; },
      [](Json& j) { j["sources"]["assumed"] = "so"; }};
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    Json spoilt = base;
    spoilers[i](spoilt);
    write("spoilt.json", spoilt.dump());
    EXPECT_EQ(validate("spoilt.json").status, 1) << i;
  }
}

}  // namespace
}  // namespace lanescope
