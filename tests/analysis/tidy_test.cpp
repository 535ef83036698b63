// SPDX-License-Identifier: MIT
#include "analysis/report/tidy.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "analysis/base/csv_text.h"
#include "analysis/report/figures.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

using CsvRow = std::map<std::string, std::string>;

/// Splits a line of CSV without line breaks in its fields.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  return fields;
}

/// The rows of a document by the names in its header.
std::vector<CsvRow> parse(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = split(line);
  EXPECT_EQ(std::set<std::string>(header.begin(), header.end()).size(), header.size()) << line;
  std::vector<CsvRow> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = split(line);
    EXPECT_EQ(fields.size(), header.size()) << line;
    CsvRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = fields.at(i);
  }
  return rows;
}

std::vector<CsvRow> rows_of(const std::vector<NamedReport>& reports, TidyRows rows) {
  return parse(tidy_csv(tidy(reports, rows)));
}

std::uint64_t sum_of(const std::vector<CsvRow>& rows, const std::string& column) {
  std::uint64_t sum = 0;
  for (const CsvRow& row : rows) sum += std::stoull(row.at(column));
  return sum;
}

InstructionRecord total_of(const Report& report) {
  InstructionRecord sum;
  for (const RunRecord& run : report.runs) sum += total(run);
  return sum;
}

class TidySums : public ::testing::TestWithParam<TidyRows> {};

TEST_P(TidySums, AreThoseOfTheReport) {
  const Report report = testing::sample_report();
  const std::vector<CsvRow> rows = rows_of({{"r.json", report}}, GetParam());
  const InstructionRecord sum = total_of(report);
  EXPECT_EQ(sum_of(rows, "issued"), sum.issued);
  EXPECT_EQ(sum_of(rows, "active"), sum.active);
  EXPECT_EQ(sum_of(rows, "overhead_issued"), sum.overhead_issued);
  EXPECT_EQ(sum_of(rows, "overhead_active"), sum.overhead_active);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, TidySums, ::testing::Values(TidyRows::kInstructions, TidyRows::kStages, TidyRows::kRuns),
    [](const auto& info) { return std::string(name_of(kTidyRows, info.param)); });

TEST(Tidy, AnInstructionHasItsRunAndItsKind) {
  const auto rows = rows_of({{"a, b.json", testing::sample_report()}}, TidyRows::kInstructions);
  CsvRow scatter = rows.at(4);  // After the add of each of the four stages.
  EXPECT_EQ(scatter["report"], "a, b.json");
  EXPECT_EQ(scatter["run"], "0");
  EXPECT_EQ(scatter["kernel"], "lockstep");
  EXPECT_EQ(scatter["width_lanes"], "8");
  EXPECT_EQ(scatter["mesh_patches"], "");
  EXPECT_EQ(scatter["jitter"], "TRUE");
  EXPECT_EQ(scatter["dice_area_px"], "1.0");
  EXPECT_EQ(scatter["workload"], "micropolygons");
  EXPECT_EQ(scatter["element"], "micropolygon");
  EXPECT_EQ(scatter["stage"], "Process");
  EXPECT_EQ(scatter["mnemonic"], "scatter");
  EXPECT_EQ(scatter["class"], "memory");
  EXPECT_EQ(scatter["charge"], "active_lanes");
  EXPECT_EQ(scatter["issued"], "1");
  EXPECT_EQ(scatter["active"], "2");
  EXPECT_EQ(scatter["utilization"], "0.25");
  EXPECT_EQ(scatter["issued_per_element"], "0.05");
}

TEST(Tidy, AStageHasItsMemory) {
  Report report = testing::sample_report();
  report.runs.resize(2);
  report.runs[1].source.pieces_observed = 0;
  const auto rows = rows_of({{"r.json", report}}, TidyRows::kStages);
  CsvRow process = rows.at(3);
  EXPECT_EQ(process["stage"], "Process");
  EXPECT_EQ(process["utilization"], "0.25");
  EXPECT_EQ(process["pieces"], "3");
  EXPECT_EQ(process["pieces_observed"], "1");
  EXPECT_EQ(process["memory_issued"], "1");
  EXPECT_EQ(process["memory_active"], "2");
  EXPECT_EQ(process["memory_lines"], "1");
  EXPECT_EQ(process["memory_conflicts"], "1");
  EXPECT_EQ(CsvRow(rows.at(0))["memory_lines"], "0") << "nothing touched";
  EXPECT_EQ(CsvRow(rows.at(4))["memory_lines"], "") << "nothing observed";
}

TEST(Tidy, ParametersAreTheUnionOverRunsAndStandTogether) {
  const NamedReport source{"r.json", testing::sample_report()};
  for (const auto& [word, rows] : kTidyRows) {
    const TidyTable table = tidy({source}, rows);
    std::vector<std::string> parameters{"report", "run"};
    add_parameter_names(source.report, parameters);
    ASSERT_GT(table.columns.size(), parameters.size());
    EXPECT_TRUE(std::equal(parameters.begin(), parameters.end(), table.columns.begin())) << word;
  }
  const auto rows = rows_of({source}, TidyRows::kRuns);
  EXPECT_EQ(CsvRow(rows.at(0))["stream_load_threshold"], "") << "LOCKSTEP has none";
  EXPECT_EQ(CsvRow(rows.at(1))["stream_load_threshold"], "0.0");
}

/// A parameter of such a name would be lost.
TEST(Tidy, NoParameterIsCalledLikeAColumn) {
  Report report = testing::sample_report();
  std::set<std::string> columns;
  for (RunRecord& run : report.runs) {
    run.configuration.arguments = {};
    run.counters.clear();
    run.metrics.clear();
    run.source.counters.clear();
    run.output.counters.clear();
  }
  for (const auto& [word, rows] : kTidyRows)
    for (const std::string& column : tidy({{"r.json", report}}, rows).columns)
      columns.insert(column);
  for (const auto& binding : run_parameters())
    columns.erase(std::string(binding.parameter().name()));
  EXPECT_GT(columns.size(), 20u);
  for (const Parameter& parameter : all_parameters())
    EXPECT_FALSE(columns.contains(std::string(parameter.name()))) << parameter.name();
}

TEST(Tidy, FiguresOfOneNameAreToldApart) {
  Report report = testing::sample_report();
  report.runs.resize(1);
  RunRecord& run = report.runs[0];
  run.source.counters = {{"tests", "of the source", "tests", 1}};
  run.counters.push_back({"issued", "a counter", "things", 2});
  run.output.counters = {{"tests", "of the output", "tests", 3}};
  run.metrics.push_back({"hits", "a ratio", "tests", "hits"});
  CsvRow row = rows_of({{"r.json", report}}, TidyRows::kRuns).at(0);
  EXPECT_EQ(row["tests"], "1");
  EXPECT_EQ(row["counter_tests"], "200");
  EXPECT_EQ(row["output_tests"], "3");
  EXPECT_EQ(row["issued"], "102");
  EXPECT_EQ(row["counter_issued"], "2");
  EXPECT_EQ(row["hits"], "40");
  EXPECT_EQ(row["metric_hits"], "5");
}

TEST(Tidy, CountersAreTheUnionOverRuns) {
  const auto rows = rows_of({{"r.json", testing::sample_report()}}, TidyRows::kRuns);
  CsvRow lockstep = rows.at(0);
  CsvRow repack = rows.at(1);
  EXPECT_EQ(lockstep["tests"], "200");
  EXPECT_EQ(lockstep["ste"], "0.2");
  EXPECT_EQ(lockstep["working_set_maximum"], "");
  EXPECT_EQ(repack["working_set_maximum"], "32");
  EXPECT_EQ(lockstep["source_hash"], "x0123456789abcdef");
  EXPECT_EQ(lockstep["results_hash"], "xffffffffffffffff");
  EXPECT_EQ(lockstep["output_hash"], "x00000000000000ff");
  EXPECT_EQ(lockstep["grids"], "4") << "a counter of the source";
  EXPECT_EQ(lockstep["samples_covered"], "10") << "a counter of the output";
  EXPECT_EQ(lockstep["kernel_ms"], "0.25");
}

TEST(Tidy, UncountedRunsHaveNoCounts) {
  Report report = testing::sample_report();
  report.runs.resize(2);
  report.runs[0].stages.clear();
  EXPECT_EQ(rows_of({{"r.json", report}}, TidyRows::kRuns).at(0)["issued"], "");
  EXPECT_EQ(rows_of({{"r.json", report}}, TidyRows::kStages).size(), 5u);
}

TEST(Tidy, ReportsFollowEachOther) {
  const Report report = testing::sample_report();
  const auto rows = rows_of({{"a.json", report}, {"b.json", report}}, TidyRows::kRuns);
  ASSERT_EQ(rows.size(), 24u);
  EXPECT_EQ(CsvRow(rows[11])["report"], "a.json");
  EXPECT_EQ(CsvRow(rows[12])["report"], "b.json");
  EXPECT_EQ(CsvRow(rows[12])["run"], "0");
}

TEST(CsvText, QuotesWhatNeedsIt) {
  EXPECT_EQ(csv_line({"a", "b c", "d,e", "f\"g", "h\ni", ""}),
            "a,b c,\"d,e\",\"f\"\"g\",\"h\ni\",\n");
  EXPECT_EQ(csv_line({"", "a"}), ",a\n");
}

}  // namespace
}  // namespace lanescope
