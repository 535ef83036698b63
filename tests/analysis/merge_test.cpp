// SPDX-License-Identifier: MIT
#include "analysis/report/merge.h"

#include <gtest/gtest.h>

#include "analysis/report/report_json.h"
#include "simulator/base/error.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

using testing::sample_report;

/// Each run of a report by itself, in the opposite order.
std::vector<NamedReport> apart(const Report& report) {
  std::vector<NamedReport> parts;
  for (std::size_t i = report.runs.size(); i-- > 0;)
    parts.push_back({fmt::format("{}.json", i), single_run(report, i)});
  return parts;
}

std::vector<std::string> order(const Report& report) {
  std::vector<std::string> all;
  for (const RunRecord& run : report.runs) {
    const Configuration& c = run.configuration;
    all.push_back(fmt::format("{} {} {} {}", c.scene, value_text(value_of(c, "micropolygon")),
                              c.kernel, c.width));
  }
  return all;
}

std::string complaint(const std::vector<NamedReport>& reports) {
  try {
    merge_reports(reports);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Merge, PutsTogetherWhatWasTakenApart) {
  Report report = sample_report();
  report.timing.source_ms = 24.0;
  report.timing.observation_ms = 6.0;
  report.timing.peak_memory_bytes = 77;
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    report.timing.kernel_ms[i] = static_cast<double>(i);
  Report merged = merge_reports(apart(report));
  EXPECT_EQ(merged.command, "");
  merged.command = report.command;
  EXPECT_EQ(report_text(merged), report_text(report));
}

TEST(Merge, ASingleRunHasItsShareOfTheTimesAndItsInstructions) {
  Report report = sample_report();
  report.instructions.push_back({"zip", "of no run but the second", "arithmetic", "active_lanes"});
  report.runs[1].stages[0].instructions.push_back({"zip", 1, 8});
  const auto runs = static_cast<double>(report.runs.size());
  report.timing.source_ms = 3.0 * runs;
  EXPECT_EQ(single_run(report, 0).instructions.size(), 2u);
  const Report second = single_run(report, 1);
  EXPECT_EQ(second.instructions.size(), 3u);
  ASSERT_EQ(second.runs.size(), 1u);
  EXPECT_EQ(second.runs[0].configuration.kernel, "repack");
  EXPECT_EQ(second.timing.kernel_ms.size(), 1u);
  EXPECT_DOUBLE_EQ(second.timing.source_ms, 3.0);
  EXPECT_DOUBLE_EQ(second.timing.wall_ms, 12.5 / runs);
}

/// A report of nothing, to which a test adds runs.
Report empty_report() {
  Report report = sample_report();
  report.runs.clear();
  report.timing.kernel_ms.clear();
  return report;
}

RunRecord& add_run(Report& report, const std::string& kernel, const std::string& scene = "teapot",
                   const std::string& micropolygon = "triangle", int width = 8) {
  report.timing.kernel_ms.push_back(static_cast<double>(report.runs.size()));
  RunRecord& run =
      report.runs.emplace_back(testing::sample_run(kernel, scene, micropolygon, {}, 1));
  run.configuration.width = width;
  return run;
}

TEST(Merge, OrdersRunsByScenesShapesKernelsAndWidths) {
  Report report = empty_report();
  add_run(report, "repack").configuration.scene = "anything";
  add_run(report, "repack");
  add_run(report, "lockstep", "teapot", "quad");
  add_run(report, "lockstep", "teapot", "triangle", 16);
  add_run(report, "lockstep", "teapot", "triangle", 8);
  add_run(report, "lockstep").configuration.kernel = "another";
  add_run(report, "repack", "ballroll", "quad", 64);
  const Report merged = merge_reports(apart(report));
  EXPECT_EQ(order(merged),
            (std::vector<std::string>{"ballroll quad repack 64", "teapot triangle lockstep 8",
                                      "teapot triangle lockstep 16", "teapot triangle repack 8",
                                      "teapot triangle another 8", "teapot quad lockstep 8",
                                      "anything triangle repack 8"}));
  EXPECT_EQ(merged.timing.kernel_ms, (std::vector<double>{6, 4, 3, 1, 5, 2, 0}));
}

/// The values of a parameter in the order in which a merged report has its runs.
std::vector<std::string> merged_values(const Report& report, std::string_view parameter) {
  std::vector<std::string> values;
  for (const RunRecord& run : merge_reports(apart(report)).runs)
    values.push_back(value_text(value_of(run.configuration, parameter)));
  return values;
}

/// One run for each value.
std::vector<std::string> order_of(const std::string& kernel, std::string_view parameter,
                                  const std::vector<Value>& values) {
  Report report = empty_report();
  for (const Value& value : values)
    set_value(add_run(report, kernel).configuration, parameter, value);
  return merged_values(report, parameter);
}

TEST(Merge, OrdersValuesByTheirType) {
  using Texts = std::vector<std::string>;
  const auto integers = [](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    return std::vector<Value>{a, b, c};
  };
  EXPECT_EQ(order_of("lockstep", "samples_per_pixel", integers(16, 4, 9)), (Texts{"4", "9", "16"}));
  EXPECT_EQ(order_of("lockstep", "seed", integers(~std::uint64_t{0}, 9, ~std::uint64_t{0} - 1)),
            (Texts{"9", "18446744073709551614", "18446744073709551615"}));
  EXPECT_EQ(order_of("lockstep", "turn_degrees", {10.0f, -0.5f, 9.0f}), (Texts{"-0.5", "9", "10"}));
  EXPECT_EQ(order_of("lockstep", "mesh_patches",
                     {std::string("phong"), std::string("linear"), {}, std::string("pn")}),
            (Texts{"none", "linear", "pn", "phong"}));
  EXPECT_EQ(order_of("lockstep", "mode",
                     {std::string("uncounted"), std::string("checked"), std::string("counting")}),
            (Texts{"counting", "checked", "uncounted"}));
  EXPECT_EQ(order_of("lockstep", "jitter", {true, false}), (Texts{"off", "on"}));
}

/// So that the runs that a table or a chart lays side by side stand together.
TEST(Merge, OrdersRunsBySettingBeforeShapeAndKernel) {
  Report report = empty_report();
  for (const char* kernel : {"repack", "lockstep"})
    for (const char* shape : {"quad", "triangle"})
      for (const std::uint64_t samples : {9u, 4u})
        set_value(add_run(report, kernel, "teapot", shape).configuration, "samples_per_pixel",
                  samples);
  EXPECT_EQ(merged_values(report, "samples_per_pixel"),
            (std::vector<std::string>{"4", "4", "4", "4", "9", "9", "9", "9"}));
  EXPECT_EQ(merged_values(report, "micropolygon"),
            (std::vector<std::string>{"triangle", "triangle", "quad", "quad", "triangle",
                                      "triangle", "quad", "quad"}));
}

TEST(Merge, OrdersParametersOfKernelsBelowTheKernelAndAboveTheWidth) {
  Report report = empty_report();
  for (const char* kernel : {"repack", "lockstep"})
    for (const int width : {16, 8})
      for (const std::uint64_t seed : {2u, 1u})
        set_value(add_run(report, kernel, "teapot", "triangle", width).configuration, "seed", seed);
  EXPECT_EQ(merged_values(report, "kernel"),
            (std::vector<std::string>{"lockstep", "lockstep", "lockstep", "lockstep", "repack",
                                      "repack", "repack", "repack"}));
  EXPECT_EQ(merged_values(report, "seed"),
            (std::vector<std::string>{"1", "1", "2", "2", "1", "1", "2", "2"}));
  EXPECT_EQ(merged_values(report, "width_lanes"),
            (std::vector<std::string>{"8", "16", "8", "16", "8", "16", "8", "16"}));
}

TEST(Merge, PutsUnknownKindsOfWorkLast) {
  Report report = empty_report();
  for (const std::string kind : {"zebras", "ants"}) {
    RunRecord& run = add_run(report, "lockstep", "ballroll");
    run.workload = kind;
    run.configuration.kernel = "kernel of " + kind;
    run.configuration.arguments = {};
    run.configuration.arguments.set("depth", std::uint64_t{3});
  }
  add_run(report, "repack");
  std::vector<std::string> kinds;
  for (const RunRecord& run : merge_reports(apart(report)).runs) kinds.push_back(run.workload);
  EXPECT_EQ(kinds, (std::vector<std::string>{"micropolygons", "ants", "zebras"}));
}

TEST(Merge, TakesEqualRunsOnceAndAddsTimes) {
  const Report report = sample_report();
  Report other = report;
  other.timing.host = "another processor";
  other.timing.peak_memory_bytes = 2097152;
  other.timing.threads = 5;
  const Report merged = merge_reports({{"a", report}, {"b", other}, {"c", report}});
  EXPECT_EQ(order(merged), order(report));
  EXPECT_DOUBLE_EQ(merged.timing.wall_ms, 37.5);
  EXPECT_EQ(merged.timing.host, "a processor; another processor");
  EXPECT_EQ(merged.timing.compiler, "a compiler");
  EXPECT_EQ(merged.timing.threads, 5);
  EXPECT_EQ(merged.timing.peak_memory_bytes, 2097152u);
}

TEST(Merge, RefusesContradictions) {
  const Report report = sample_report();
  Report other = report;
  other.runs[2].counters[0].value += 1;
  EXPECT_EQ(complaint({{"a.json", report}, {"b.json", other}})
                .rfind("b.json: has other counts than a.json for the same parameters: "
                       "{\"kernel\":\"lockstep\",\"width_lanes\":8,\"scene\":\"ballroll\"",
                       0),
            0u);
  set_value(other.runs[2].configuration, "seed", std::uint64_t{2});
  EXPECT_EQ(complaint({{"a.json", report}, {"b.json", other}}), "");
}

TEST(Merge, RefusesOtherVersionsAndExplanations) {
  const Report report = sample_report();
  Report other = report;
  other.instructions[0].meaning = "something else";
  EXPECT_EQ(complaint({{"a.json", report}, {"b.json", other}}),
            "b.json: explains the instruction 'add' differently from a.json");
  other = report;
  other.commit.clear();
  EXPECT_EQ(complaint({{"a.json", report}, {"b.json", other}}),
            "b.json: was made by lanescope 0.1.0, and a.json by 0.1.0 (commit 0123456789ab); merge "
            "reports of one version");
}

}  // namespace
}  // namespace lanescope
