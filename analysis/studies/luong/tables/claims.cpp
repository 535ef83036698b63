// SPDX-License-Identifier: MIT
// What the text of the thesis says beside its tables, against our figures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

using OverWidth = std::function<std::optional<double>(int width)>;

/// Of a claim; n/a where there is nothing to judge.
Cell verdict(std::optional<bool> holds) { return {{}, {}, !holds ? "n/a" : *holds ? "yes" : "no"}; }

/// Claims are of the thesis's scenes in its setting: nothing else can break one.
void withdraw_verdicts(TableData& data) {
  for (Row& row : data.rows)
    if (!row.cells.empty()) row.cells.back().words = kNotComparable;
}

/// The claim is a number: it holds if ours is within `tolerance` of it, as a share of it.
Row near_row(const std::string& label, const Figure& figure, double tolerance) {
  std::optional<bool> holds;
  if (figure.ours && figure.paper)
    holds = std::abs(*figure.ours - *figure.paper) <= tolerance * *figure.paper;
  return {label, {Cell{figure, {}, {}}, verdict(holds)}};
}

/// The claim is an upper bound.
Row bound_row(const std::string& label, const Figure& figure) {
  std::optional<bool> holds;
  if (figure.ours && figure.paper) holds = *figure.ours <= *figure.paper;
  return {label, {Cell{figure, {}, {}}, verdict(holds)}};
}

/// Between which widths REPACK comes to need fewer instructions than LOCKSTEP.
std::optional<std::string> crossover(const std::vector<int>& widths, const OverWidth& lockstep,
                                     const OverWidth& repack) {
  int before = 0;
  for (const int width : widths) {
    const auto a = lockstep(width);
    const auto b = repack(width);
    if (!a || !b) return std::nullopt;
    if (*b < *a)
      return before == 0 ? fmt::format("up to W = {}", width)
                         : fmt::format("between W = {} and {}", before, width);
    before = width;
  }
  return fmt::format("above W = {}", before);
}

Row crossover_row(const ReportView& view, std::string_view facet) {
  const Series lockstep{"lockstep", std::string(facet)};
  const Series repack{"repack", std::string(facet)};
  const bool quads = facet == kQuad;
  const bool is_comparable = differences_from_thesis(view).empty();
  const auto ours = crossover(
      widths_of(view, lockstep), [&](int width) { return instructions(view, lockstep, width); },
      [&](int width) { return instructions(view, repack, width); });
  const auto theirs = crossover(
      {kThesisWidths.begin(), kThesisWidths.end()},
      [&](int width) {
        return thesis_value({quads ? "table_4_4" : "table_4_1", "ops_per_mp"}, width);
      },
      [&](int width) {
        return thesis_value({quads ? "table_4_5" : "table_4_2", "ops_per_mp"}, width);
      });
  std::optional<bool> holds;
  if (ours) holds = ours == theirs;
  return {fmt::format("REPACK overtakes, {}", plural(facet)),
          {Cell{{}, {}, ours.value_or("n/a") + (is_comparable ? " (thesis: " + *theirs + ")" : "")},
           verdict(holds)}};
}

/// Utilization of Test and Test Stream-load together that table 4.2 implies: each stage's,
/// weighted with its share of the instructions.
std::optional<double> implied_test_and_load(int width) {
  double busy = 0.0;
  double issued = 0.0;
  for (const std::string_view stage : {"Test", "Test Stream-load"}) {
    const auto share = thesis_value({"table_4_2", "fraction_of_time", stage}, width);
    const auto utilization = thesis_value({"table_4_2", "utilization", stage}, width);
    if (!share || !utilization) return std::nullopt;
    busy += *share * *utilization;
    issued += *share;
  }
  return quotient(busy, issued);
}

void add_test_and_load(TableData& data, const ReportView& view) {
  data.rows.push_back({"REPACK's Test and Test Stream-load together (4.1.2)", {}});
  for (const int width : widths_of(view, kRepackTriangle))
    data.rows.push_back(near_row(fmt::format("As table 4.2 implies, W = {}", width),
                                 {test_and_load_utilization(view, kRepackTriangle, width),
                                  implied_test_and_load(width), &kPercent},
                                 0.05));
  data.rows.push_back(near_row(
      fmt::format("As the text says, W = {}", kClaimWidth),
      {test_and_load_utilization(view, kRepackTriangle, kClaimWidth),
       thesis_value({"text_claims", "test_and_stream_load_combined_utilization"}), &kPercent},
      0.05));
}

void add_quads(TableData& data, const ReportView& view) {
  data.rows.push_back({"Quads against triangles (4.2)", {}});
  data.rows.push_back(near_row(
      "STE, quads / triangles",
      {quotient(sample_test_efficiency(view, kQuad), sample_test_efficiency(view, kTriangle)),
       thesis_value({"text_claims", "quads_ste_over_triangles"}), &kFactor},
      0.15));
  for (const std::string_view kernel : {"lockstep", "repack"})
    data.rows.push_back(
        near_row(fmt::format("Instructions saved, {}", kernel),
                 {saved_by_quads(view, kernel, kClaimWidth),
                  thesis_value({"text_claims", "quads_total_operations_saved"}), &kPercent},
                 0.25));
  data.rows.push_back(
      near_row("Instructions/mp, quads / triangles",
               {quotient(instructions(view, kLockstepQuad, kClaimWidth),
                         instructions(view, kLockstepTriangle, kClaimWidth)),
                thesis_value({"text_claims", "quad_over_triangle_ops_per_mp"}), &kFactor},
               0.10));
}

void add_working_set(TableData& data, const ReportView& view) {
  data.rows.push_back({"REPACK's working set (4.1.2)", {}});
  const auto thesis = [](std::string_view name) {
    return thesis_value({"text_claims", "repack_working_set_over_width", name});
  };
  data.rows.push_back(near_row(
      "Average",
      {average_working_set(view, kRepackTriangle, kClaimWidth), thesis("average"), &kWidths},
      0.10));
  std::optional<double> largest;
  for (const int width : widths_of(view, kRepackTriangle))
    if (const auto one = largest_working_set(view, kRepackTriangle, width))
      largest = std::max(largest.value_or(0.0), *one);
  data.rows.push_back(bound_row("Maximum, any W", {largest, thesis("maximum"), &kWidths}));
}

void add_conflicts(TableData& data, const ReportView& view) {
  data.rows.push_back({"Conflicts at W = 64 (4.1.2)", {}});
  const auto thesis = thesis_value({"text_claims", "conflict_rate_max_at_w64"});
  for (const Series& series : {kLockstepTriangle, kRepackTriangle}) {
    data.rows.push_back(
        bound_row(fmt::format("Of Process invocations, {}", series.kernel),
                  {conflicting_invocations(view, series, 64), thesis, &kSmallPercent}));
    data.rows.push_back(bound_row(fmt::format("Of hits, {}", series.kernel),
                                  {conflicting_hits(view, series, 64), thesis, &kSmallPercent}));
  }
}

void add_rate(TableData& data, const ReportView& view) {
  static constexpr Unit kBillions{"instructions/s", 1e-9, " G/s", 1, 0, Difference::kRelative};
  data.rows.push_back({fmt::format("60 frames a second, W = {} (4.3)", kClaimWidth), {}});
  const auto thesis =
      thesis_value({"text_claims", "larrabee_units_at_60fps", "vector_ops_per_second"});
  for (const bool before_culling : {false, true})
    data.rows.push_back(near_row(
        before_culling ? "Instructions, mp before culling" : "Instructions, mp rasterized",
        {instructions_per_second(view, kLockstepTriangle, before_culling), thesis, &kBillions},
        0.15));
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "What the text of the thesis says";
  data.row_header = "Claim";
  data.columns = {"Measured", "Holds"};
  data.rows.push_back({"REPACK needs fewer instructions than LOCKSTEP (4.1)", {}});
  data.rows.push_back(crossover_row(view, kTriangle));
  data.rows.push_back(crossover_row(view, kQuad));
  add_test_and_load(data, view);
  add_quads(data, view);
  add_working_set(data, view);
  add_conflicts(data, view);
  add_rate(data, view);
  if (!differences_from_thesis(view).empty()) withdraw_verdicts(data);
  data.notes = {
      fmt::format("Measured at W = {} on triangles where nothing else is said. Instructions are "
                  "without Setup.",
                  kClaimWidth),
      "A number holds within 5% of itself (utilization), 10% (instructions/mp of quads, average "
      "working set), 15% (STE, rates) or 25% (\"about 20%\" saved); a maximum holds if it is not "
      "exceeded."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_claims{"claims", "what the text of the thesis says beside its tables",
                                  luong::compared<luong::build>};

}  // namespace lanescope
