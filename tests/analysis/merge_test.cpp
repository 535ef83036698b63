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
    all.push_back(
        fmt::format("{} {} {} {}", c.scene, name_of(kShapes, c.shape()), c.kernel, c.width));
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
  report.timing.dicing_ms = 24.0;
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
  report.timing.dicing_ms = 3.0 * runs;
  EXPECT_EQ(single_run(report, 0).instructions.size(), 2u);
  const Report second = single_run(report, 1);
  EXPECT_EQ(second.instructions.size(), 3u);
  ASSERT_EQ(second.runs.size(), 1u);
  EXPECT_EQ(second.runs[0].configuration.kernel, "repack");
  EXPECT_EQ(second.timing.kernel_ms.size(), 1u);
  EXPECT_DOUBLE_EQ(second.timing.dicing_ms, 3.0);
  EXPECT_DOUBLE_EQ(second.timing.wall_ms, 12.5 / runs);
}

TEST(Merge, OrdersRunsByScenesShapesKernelsAndWidths) {
  Report report = sample_report();
  report.runs.clear();
  const auto add = [&](const std::string& kernel, const std::string& scene, Micropolygon shape,
                       int width) {
    report.runs.push_back(testing::sample_run(kernel, scene, shape, {}, 1));
    report.runs.back().configuration.width = width;
  };
  add("repack", "anything", Micropolygon::kTriangle, 8);
  add("repack", "teapot", Micropolygon::kTriangle, 8);
  add("lockstep", "teapot", Micropolygon::kQuad, 8);
  add("lockstep", "teapot", Micropolygon::kTriangle, 16);
  add("lockstep", "teapot", Micropolygon::kTriangle, 8);
  add("another", "teapot", Micropolygon::kTriangle, 8);
  add("repack", "ballroll", Micropolygon::kQuad, 64);
  report.timing.kernel_ms = {0, 1, 2, 3, 4, 5, 6};
  const Report merged = merge_reports(apart(report));
  EXPECT_EQ(order(merged),
            (std::vector<std::string>{"ballroll quad repack 64", "teapot triangle lockstep 8",
                                      "teapot triangle lockstep 16", "teapot triangle repack 8",
                                      "teapot triangle another 8", "teapot quad lockstep 8",
                                      "anything triangle repack 8"}));
  EXPECT_EQ(merged.timing.kernel_ms, (std::vector<double>{6, 4, 3, 1, 5, 2, 0}));
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
                       "{\"kernel\":\"lockstep\",\"width_lanes\":8,\"micropolygon\":\"quad\"",
                       0),
            0u);
  other.runs[2].configuration.seed = 2;
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
