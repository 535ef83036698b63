// SPDX-License-Identifier: MIT
// The JSON Schema of reports: that it takes what the program writes and refuses the rest. A
// validator that knows nothing of the program decides (tests/schema/validate.py).
#include <gtest/gtest.h>

#include "analysis/base/json_text.h"
#include "analysis/report/report_json.h"
#include "tests/analysis/sample_report.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;
using testing::Outcome;

const std::string kSchema = LANESCOPE_SOURCE_DIR "/analysis/data/report.schema.json";

class ReportSchema : public testing::InEmptyDirectory {
 protected:
  /// Debian's interpreter: others need not have its packages.
  Outcome validate(const std::string& files) const {
    return testing::shell("/usr/bin/python3 '" LANESCOPE_SOURCE_DIR "/tests/schema/validate.py' '" +
                              kSchema + "' " + files,
                          directory());
  }
};

TEST_F(ReportSchema, TakesWhatTheProgramWrites) {
  const std::string small = " --resolution 48x30 --json ";
  write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  run("run --scene teapot --kernel rastmp,lockstep,repack --micropolygon triangle,quad" + small +
      "run.json");
  run("run --scene teapot --width 8 --mode uncounted" + small + "uncounted.json");
  run("run --scene teapot --width 8 --mode checked --edges precomputed" + small + "checked.json");
  run("run --mesh mesh.obj --patches pn --width 8 --seed 18446744073709551615" + small +
      "mesh.json");
  run("tables --scene all --turn 12.5" + small + "tables.json");
  const Outcome outcome = validate("run.json uncounted.json checked.json mesh.json tables.json");
  EXPECT_EQ(outcome.status, 0) << outcome.output << outcome.errors;
  EXPECT_EQ(outcome.output, "");
}

/// A change to a good report, and where the validator finds it.
struct Spoilt {
  const char* name;
  void (*spoil)(Json&);
  std::string where;
};

const std::vector<Spoilt> kSpoilt{
    {"missing_member", [](Json& j) { j["runs"][0].erase("scene_hash"); }, "/runs/0"},
    {"missing_parameter", [](Json& j) { j["runs"][0]["parameters"].erase("seed"); },
     "/runs/0/parameters"},
    {"unknown_member", [](Json& j) { j["runs"][1]["stages"][0]["issued"] = 3; },
     "/runs/1/stages/0"},
    {"unknown_at_the_top", [](Json& j) { j["notes"] = ""; }, "/"},
    {"negative_count", [](Json& j) { j["runs"][0]["counters"][0]["value"] = -1; },
     "/runs/0/counters/0/value"},
    {"count_as_text", [](Json& j) { j["runs"][0]["stages"][0]["histogram"][2] = "1"; },
     "/runs/0/stages/0/histogram/2"},
    {"count_as_fraction", [](Json& j) { j["runs"][0]["stages"][0]["lane_active"][0] = 1.5; },
     "/runs/0/stages/0/lane_active/0"},
    {"newer_version", [](Json& j) { j["schema"]["version"] = kReportVersion + 1; },
     "/schema/version"},
    {"short_hash", [](Json& j) { j["runs"][0]["hits_hash"] = "0x12"; }, "/runs/0/hits_hash"},
    {"other_mode", [](Json& j) { j["runs"][0]["parameters"]["mode"] = "fast"; },
     "/runs/0/parameters/mode"},
    {"other_class", [](Json& j) { j["instructions"][0]["class"] = "other"; },
     "/instructions/0/class"},
    {"value_as_text", [](Json& j) { j["runs"][0]["stages"][0]["utilization"]["value"] = "1"; },
     "/runs/0/stages/0/utilization/value"},
};

TEST_F(ReportSchema, RefusesTheRest) {
  const Json good = to_json(testing::sample_report());
  write("good.json", json_text(good));
  std::string files = "good.json";
  for (const Spoilt& spoilt : kSpoilt) {
    Json json = good;
    spoilt.spoil(json);
    write(spoilt.name + std::string(".json"), json_text(json));
    files += fmt::format(" {}.json", spoilt.name);
  }
  const Outcome outcome = validate(files);
  EXPECT_EQ(outcome.status, 1) << outcome.errors;
  EXPECT_EQ(outcome.output.find("good.json"), std::string::npos) << outcome.output;
  for (const Spoilt& spoilt : kSpoilt) {
    const std::string complaint = fmt::format("\n{}.json:{}: ", spoilt.name, spoilt.where);
    EXPECT_NE(("\n" + outcome.output).find(complaint), std::string::npos)
        << complaint << outcome.output;
  }
}

TEST_F(ReportSchema, IsPrintedByTheProgram) { EXPECT_EQ(run("schema").output, read_file(kSchema)); }

/// Calls f(pointer, value) for every object of a document.
template <class F>
void for_each_object(const Json& json, const std::string& pointer, F&& f) {
  if (json.is_object()) f(pointer, json);
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) for_each_object(value, pointer + "/" + key, f);
}

TEST_F(ReportSchema, IsStrictAndExplainsEveryMember) {
  const Json schema = Json::parse(report_json_schema());
  std::size_t objects = 0;
  for_each_object(schema, "", [&](const std::string& where, const Json& json) {
    if (!json.contains("properties") || !json["properties"].is_object()) return;
    ++objects;
    EXPECT_EQ(json["additionalProperties"], false) << where;
    std::vector<std::string> names;
    for (const auto& [name, property] : json["properties"].items()) {
      names.push_back(name);
      EXPECT_TRUE(property.contains("description")) << where << "/" << name;
    }
    EXPECT_EQ(json["required"], Json(names)) << where;
  });
  EXPECT_GT(objects, 10u);
}

}  // namespace
}  // namespace lanescope
