// SPDX-License-Identifier: MIT
#include "analysis/report/tidy.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/base/csv_text.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/figures.h"

namespace lanescope {
namespace {

std::string number_text(std::optional<double> value) {
  return value ? fmt::format("{}", *value) : "";
}
std::string count_text(std::uint64_t count) { return fmt::format("{}", count); }
/// As both R and pandas read it.
std::string switch_text(bool on) { return on ? "TRUE" : "FALSE"; }
std::string tidy_hash(std::uint64_t hash) { return fmt::format("x{:016x}", hash); }

std::string parameter_text(const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return "";
  if (const bool* on = std::get_if<bool>(&value)) return switch_text(*on);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  return value_json(value).dump();
}

/// One row while it is made: fields by the names of their columns.
class RowWriter {
 public:
  explicit RowWriter(TidyTable& table) : table_(table) { table_.rows.emplace_back(); }

  /// Adds a column to the table the first time that a row has it.
  void set(const std::string& column, std::string text) {
    auto& columns = table_.columns;
    const auto place = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) -
                                                columns.begin());
    if (place == columns.size()) columns.push_back(column);
    auto& row = table_.rows.back();
    row.resize(std::max(row.size(), place + 1));
    row[place] = std::move(text);
    names_.insert(column);
  }

  /// Sets a figure of a kind (source, output, ...) of which the run names the figures itself: the
  /// kind is in the name of the column only if the row has one of that name.
  void set_figure(const std::string& kind, const std::string& name, std::string text) {
    set(names_.contains(name) ? kind + "_" + name : name, std::move(text));
  }

 private:
  TidyTable& table_;
  std::set<std::string> names_;  ///< Of the columns that are set.
};

/// A run and where it stands.
struct Place {
  const NamedReport& source;
  std::size_t index;
  const RunRecord& run() const { return source.report.runs[index]; }
  int width() const { return run().configuration.width; }
};

void set_run(RowWriter& row, const Place& place) {
  row.set("report", place.source.name);
  row.set("run", count_text(std::uint64_t{place.index}));
  for (const auto& [name, value] : all_values(place.run().configuration).all())
    row.set(name, parameter_text(value));
  row.set("workload", place.run().workload);
  row.set("element", place.run().element.name);
}

void set_counts(RowWriter& row, const InstructionRecord& counts, const Place& place) {
  const Ratio lanes{counts.active, counts.issued * static_cast<std::uint64_t>(place.width())};
  const auto elements = place.run().elements();
  row.set("issued", count_text(counts.issued));
  row.set("active", count_text(counts.active));
  row.set("overhead_issued", count_text(counts.overhead_issued));
  row.set("overhead_active", count_text(counts.overhead_active));
  row.set("utilization", number_text(lanes.value()));
  row.set("issued_per_element",
          number_text(elements ? Ratio{counts.issued, *elements}.value() : std::nullopt));
}

void set_pieces(RowWriter& row, const SourceRecord& source) {
  row.set("pieces", count_text(source.pieces));
  row.set("pieces_observed", count_text(source.pieces_observed));
}

void set_counters(RowWriter& row, const std::string& kind,
                  const std::vector<CounterRecord>& counters) {
  for (const CounterRecord& counter : counters)
    row.set_figure(kind, counter.name, count_text(counter.value));
}

void add_instruction_rows(TidyTable& table, const Place& place) {
  for (const StageRecord& stage : place.run().stages)
    for (const InstructionRecord& counts : stage.instructions) {
      const auto& entries = place.source.report.instructions;
      const auto entry = std::find_if(entries.begin(), entries.end(),
                                      [&](const auto& e) { return e.mnemonic == counts.mnemonic; });
      RowWriter row(table);
      set_run(row, place);
      row.set("stage", stage.name);
      row.set("mnemonic", counts.mnemonic);
      row.set("class", entry == entries.end() ? "" : entry->instruction_class);
      row.set("charge", entry == entries.end() ? "" : entry->charge);
      set_counts(row, counts, place);
    }
}

void add_stage_rows(TidyTable& table, const Place& place) {
  const SourceRecord& source = place.run().source;
  const auto observation = [&](std::uint64_t sum) {
    return source.pieces_observed > 0 ? count_text(sum) : "";
  };
  for (const StageRecord& stage : place.run().stages) {
    const MemoryRecord memory = stage.memory_total();
    RowWriter row(table);
    set_run(row, place);
    row.set("stage", stage.name);
    set_counts(row, stage.total(), place);
    set_pieces(row, source);
    row.set("memory_issued", observation(memory.issued));
    row.set("memory_active", observation(memory.active));
    row.set("memory_lines", observation(memory.lines));
    row.set("memory_conflicts", observation(memory.conflicts));
  }
}

void add_run_row(TidyTable& table, const Place& place) {
  const RunRecord& run = place.run();
  RowWriter row(table);
  set_run(row, place);
  row.set("source_hash", tidy_hash(run.source.hash));
  row.set("results_hash", tidy_hash(run.results_hash));
  row.set("output_hash", tidy_hash(run.output.hash));
  set_pieces(row, run.source);
  row.set("kernel_ms", number_text(place.source.report.kernel_ms(place.index)));
  if (!run.stages.empty()) set_counts(row, total(run), place);
  set_counters(row, "source", run.source.counters);
  set_counters(row, "counter", run.counters);
  set_counters(row, "output", run.output.counters);
  for (const MetricRecord& metric : run.metrics)
    row.set_figure("metric", metric.name,
                   number_text(counter_ratio(run, metric.numerator, metric.denominator)));
}

/// What every row has: the parameters of all runs stand together, though not all runs have all.
std::vector<std::string> first_columns(const std::vector<NamedReport>& reports) {
  std::vector<std::string> columns{"report", "run"};
  for (const NamedReport& source : reports) add_parameter_names(source.report, columns);
  return columns;
}

void add_rows(TidyTable& table, const Place& place, TidyRows rows) {
  switch (rows) {
    case TidyRows::kInstructions:
      return add_instruction_rows(table, place);
    case TidyRows::kStages:
      return add_stage_rows(table, place);
    case TidyRows::kRuns:
      return add_run_row(table, place);
  }
}

}  // namespace

TidyTable tidy(const std::vector<NamedReport>& reports, TidyRows rows) {
  TidyTable table{first_columns(reports), {}};
  for (const NamedReport& source : reports)
    for (std::size_t i = 0; i < source.report.runs.size(); ++i) add_rows(table, {source, i}, rows);
  for (auto& row : table.rows) row.resize(table.columns.size());
  return table;
}

std::string tidy_csv(const TidyTable& table) {
  std::string text = csv_line(table.columns);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

}  // namespace lanescope
