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

class ReportSchema : public testing::InEmptyDirectory {
 protected:
  ReportSchema() : schema(run("schema").output) { write("report.schema.json", schema); }

  /// Debian's interpreter: others need not have its packages.
  Outcome validate(const std::string& files) const {
    return testing::shell("/usr/bin/python3 '" LANESCOPE_SOURCE_DIR
                          "/tests/schema/validate.py' report.schema.json " +
                              files,
                          directory());
  }

  const std::string schema;  ///< As the program prints it.
};

TEST_F(ReportSchema, TakesWhatTheProgramWrites) {
  const std::string small = " --resolution 48x30 --json ";
  write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  run("run --scene teapot --kernel rastmp,lockstep,repack --micropolygon triangle,quad" + small +
      "run.json");
  run("run --scene teapot --width 1:3 --msaa 1,4 --stream-load-threshold 0,0.5" + small +
      "lists.json");
  run("run --scene teapot --width 8 --mode uncounted" + small + "uncounted.json");
  run("run --scene teapot --width 8 --mode checked --edges precomputed" + small + "checked.json");
  run("run --mesh mesh.obj --patches pn --width 8 --seed 18446744073709551615" + small +
      "mesh.json");
  run("tables --scene all --turn 12.5" + small + "tables.json");
  const Outcome outcome =
      validate("run.json lists.json uncounted.json checked.json mesh.json tables.json");
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
    {"missing_member", [](Json& j) { j["runs"][0].erase("source"); }, "/runs/0"},
    {"missing_parameter", [](Json& j) { j["runs"][0]["parameters"].erase("seed"); },
     "/runs/0/parameters"},
    {"unknown_parameter", [](Json& j) { j["runs"][0]["parameters"]["speed"] = 1; },
     "/runs/0/parameters"},
    {"parameter_of_another_kernel",
     [](Json& j) { j["runs"][0]["parameters"]["stream_load_threshold"] = 0.5; },
     "/runs/0/parameters"},
    {"parameter_out_of_range", [](Json& j) { j["runs"][0]["parameters"]["width_lanes"] = 65; },
     "/runs/0/parameters/width_lanes"},
    {"parameter_of_a_kind_out_of_range", [](Json& j) { j["runs"][0]["parameters"]["seed"] = -1; },
     "/runs/0/parameters/seed"},
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
    {"short_hash", [](Json& j) { j["runs"][0]["results_hash"] = "0x12"; }, "/runs/0/results_hash"},
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

/// The tests have kernels that the program does not have: those change nothing but the parameters.
TEST_F(ReportSchema, IsPrintedByTheProgram) {
  Json printed = Json::parse(schema);
  Json ours = Json::parse(report_json_schema());
  for (Json* json : {&printed, &ours}) {
    EXPECT_FALSE((*json)["$defs"]["parameters"]["allOf"].empty());
    (*json)["$defs"].erase("parameters");
  }
  EXPECT_EQ(printed, ours);
  EXPECT_EQ(json_text(Json::parse(schema)), schema);
}

/// Calls f(pointer, value) for every object of a document.
template <class F>
void for_each_object(const Json& json, const std::string& pointer, F&& f) {
  if (json.is_object()) f(pointer, json);
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) for_each_object(value, pointer + "/" + key, f);
}

/// All members are required, but for those that reports of the version came to have later.
void expect_strict(const Json& object, const std::string& where) {
  EXPECT_EQ(object["additionalProperties"], false) << where;
  std::vector<std::string> names;
  for (const auto& [name, property] : object["properties"].items()) {
    const bool is_later = (where == "/$defs/source_line" && name == "block") ||
                          (where == "/$defs/stage" && name == "lane_groups");
    if (!is_later) names.push_back(name);
    EXPECT_TRUE(property.contains("description") || property.contains("const"))
        << where << "/" << name;
  }
  EXPECT_EQ(object["required"], Json(names)) << where;
}

/// Other kernels than the program's have parameters that it does not know; those of its own are
/// listed, and no others.
TEST_F(ReportSchema, IsStrictAndExplainsEveryMember) {
  const Json json = Json::parse(schema);
  std::size_t objects = 0;
  std::size_t kernels_listed = 0;
  for_each_object(json, "", [&](const std::string& where, const Json& object) {
    if (where.ends_with("/then")) {
      ++kernels_listed;
      expect_strict(object, where);
    }
    if (!object.contains("properties") || !object["properties"].is_object()) return;
    if (where.find("/parameters") != where.npos) return;
    ++objects;
    expect_strict(object, where);
    for (const auto& [name, property] : object["properties"].items())
      EXPECT_TRUE(property.contains("description")) << where << "/" << name;
  });
  EXPECT_GT(objects, 10u);
  EXPECT_EQ(kernels_listed, testing::listed("kernels").size());
}

}  // namespace
}  // namespace lanescope
