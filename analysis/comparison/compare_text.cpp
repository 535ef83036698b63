// SPDX-License-Identifier: MIT
// Comparisons as documents.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/base/json_text.h"
#include "analysis/base/markdown_text.h"
#include "analysis/comparison/compare.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kColumns = 5;
using Cells = std::array<std::string, kColumns>;
const Cells kHeader{"Figure", "old", "new", "change", "relative"};

std::string shown_value(const Json& value, const Unit& unit) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? shown(Figure{value.get<double>(), {}, &unit}) : value.dump();
}

std::string shown_change(const Change& change) {
  if (!change.difference) return "";
  if (change.unit->name == kCount.name) return fmt::format("{:+.0f}", *change.difference);
  if (change.unit->name == kPercent.name)
    return fmt::format("{:+.3g} points", *change.difference * kPercent.scale);
  return fmt::format("{:+.3g}", *change.difference);
}

std::string shown_relative(const Change& change) {
  std::string text;
  if (change.relative)
    text = fmt::format("{:+.3g}%", 100.0 * *change.relative);
  else if (change.difference)
    text = "from 0";
  else
    text = change.before.is_null() ? "appears" : change.after.is_null() ? "is gone" : "differs";
  return change.within_tolerance ? text + " (tolerated)" : text;
}

std::string label_of(const Change& change) {
  return change.stage.empty() ? change.figure : change.stage + ": " + change.figure;
}

std::vector<Cells> lines_of(const RunChanges& run, std::size_t count) {
  std::vector<Cells> lines{kHeader};
  for (std::size_t i = 0; i < count; ++i) {
    const Change& change = run.changes[i];
    lines.push_back({label_of(change), shown_value(change.before, *change.unit),
                     shown_value(change.after, *change.unit), shown_change(change),
                     shown_relative(change)});
  }
  return lines;
}

std::string aligned(const std::vector<Cells>& lines) {
  std::array<std::size_t, kColumns> widths{};
  for (const Cells& cells : lines)
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], cells[i].size());
  std::string text;
  for (const Cells& cells : lines) {
    text += fmt::format("  {:<{}}", cells[0], widths[0]);
    for (std::size_t i = 1; i < kColumns; ++i) text += fmt::format("  {:>{}}", cells[i], widths[i]);
    text += '\n';
  }
  return text;
}

std::string markdown_table(const std::vector<Cells>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += '|';
    for (const std::string& cell : lines[i]) text += fmt::format(" {} |", markdown_text(cell));
    text += '\n';
    if (i == 0) text += "| --- | ---: | ---: | ---: | ---: |\n";
  }
  return text;
}

/// A change and its run.
struct Largest {
  const RunChanges* run = nullptr;
  const Change* change = nullptr;
};

/// The change of the largest relative size; a detail only if there are only details.
Largest largest_of(const Comparison& comparison) {
  const auto rank = [](const Change& change) {
    return std::pair(!change.is_detail, std::abs(*change.relative));
  };
  Largest largest;
  for (const RunChanges& run : comparison.runs)
    for (const Change& change : run.changes)
      if (change.relative && (!largest.change || rank(change) > rank(*largest.change)))
        largest = {&run, &change};
  return largest;
}

std::string summary(const ComparisonDocument& document) {
  const Comparison& c = document.comparison;
  const auto tolerated = std::count_if(c.runs.begin(), c.runs.end(), [](const RunChanges& run) {
    return std::all_of(run.changes.begin(), run.changes.end(),
                       [](const Change& change) { return change.within_tolerance; });
  });
  std::string text = fmt::format("{} runs compared: {} differ", c.compared, c.runs.size());
  if (tolerated > 0)
    text += fmt::format(" ({} within {:.6g}%)", tolerated, 100.0 * document.options.tolerance);
  text += fmt::format(", {} only in {}, {} only in {}", c.only_before.size(), document.before.name,
                      c.only_after.size(), document.after.name);
  if (const Largest largest = largest_of(c); largest.change)
    text += fmt::format("; largest change {:+.3g}% ({} of {})", 100.0 * *largest.change->relative,
                        label_of(*largest.change), largest.run->run);
  return text + '\n';
}

std::string maker(const Report& report) {
  return fmt::format("lanescope {}, commit {}", report.program_version,
                     report.commit.empty() ? "unknown" : report.commit);
}

/// Who made the reports, if that is not the same; after `gap`.
std::string makers(const ComparisonDocument& document, std::string_view gap) {
  const std::string before = maker(document.before.report);
  const std::string after = maker(document.after.report);
  if (before == after) return "";
  return fmt::format("{}{} is of {}; {} is of {}\n", gap, document.before.name, before,
                     document.after.name, after);
}

std::string lone_runs(const std::string& where, const std::vector<LoneRun>& runs, bool markdown) {
  if (runs.empty()) return "";
  if (!markdown) {
    std::string text = fmt::format("\nOnly in {}:\n", where);
    for (const LoneRun& run : runs) text += fmt::format("  {}\n", run.run);
    return text;
  }
  std::string text = fmt::format("\n### Only in {}:\n\n", markdown_text(where));
  for (const LoneRun& run : runs) text += fmt::format("- {}\n", markdown_text(run.run));
  return text;
}

Json maker_json(const NamedReport& source) {
  const Report& report = source.report;
  return {{"report", source.name},
          {"version", report.program_version},
          {"commit", report.commit.empty() ? Json(nullptr) : Json(report.commit)}};
}

Json change_json(const Change& change) {
  return {{"stage", change.stage.empty() ? Json(nullptr) : Json(change.stage)},
          {"figure", change.figure},
          {"old", change.before},
          {"new", change.after},
          {"difference", number_or_null(change.difference)},
          {"relative", number_or_null(change.relative)},
          {"within_tolerance", change.within_tolerance}};
}

Json run_json(const RunChanges& run) {
  Json changes = Json::array();
  for (const Change& change : run.changes) changes.push_back(change_json(change));
  return {{"parameters", run.parameters}, {"changes", changes}};
}

Json lone_json(const std::vector<LoneRun>& runs) {
  Json list = Json::array();
  for (const LoneRun& run : runs) list.push_back(run.parameters);
  return list;
}

}  // namespace

std::string ComparisonDocument::text(bool markdown) const {
  const std::string head = summary(*this) + makers(*this, markdown ? "\n" : "");
  std::string document = markdown ? markdown_text(head) : head;
  for (const RunChanges& run : comparison.runs) {
    const std::size_t all = run.changes.size();
    const std::size_t count = limit == 0 ? all : std::min(limit, all);
    const std::vector<Cells> lines = lines_of(run, count);
    document += markdown
                    ? fmt::format("\n### {}\n\n{}", markdown_text(run.run), markdown_table(lines))
                    : fmt::format("\n{}\n{}", run.run, aligned(lines));
    if (count < all)
      document += fmt::format("{}... and {} more\n", markdown ? "\n" : "  ", all - count);
  }
  return document + lone_runs(before.name, comparison.only_before, markdown) +
         lone_runs(after.name, comparison.only_after, markdown);
}

Json ComparisonDocument::json() const {
  Json runs = Json::array();
  for (const RunChanges& run : comparison.runs) runs.push_back(run_json(run));
  return {{"schema", {{"name", "lanescope-comparison"}, {"version", 1}}},
          {"old", maker_json(before)},
          {"new", maker_json(after)},
          {"tolerance", options.tolerance},
          {"ignored_parameters", options.ignored},
          {"same", comparison.same()},
          {"runs_compared", comparison.compared},
          {"runs", runs},
          {"only_in_old", lone_json(comparison.only_before)},
          {"only_in_new", lone_json(comparison.only_after)}};
}

}  // namespace lanescope
