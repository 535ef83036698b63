// SPDX-License-Identifier: MIT
#include "analysis/report/tidy.h"

#include <fmt/format.h>

#include <algorithm>

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

std::string parameter_text(const nlohmann::ordered_json& value) {
  if (value.is_null()) return "";
  if (value.is_boolean()) return switch_text(value.get<bool>());
  return value.is_string() ? value.get<std::string>() : value.dump();
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
  }

 private:
  TidyTable& table_;
};

/// A run and where it stands.
struct Place {
  const NamedReport& source;
  std::size_t index;
  const RunRecord& run() const { return source.report.runs[index]; }
  int width() const { return run().configuration.width; }
};

void set_parameters(RowWriter& row, const Place& place) {
  row.set("report", place.source.name);
  row.set("run", count_text(std::uint64_t{place.index}));
  const auto parameters = configuration_json(place.run().configuration);
  for (const auto& [name, value] : parameters.items()) row.set(name, parameter_text(value));
}

void set_counts(RowWriter& row, const InstructionRecord& counts, const Place& place) {
  const Ratio lanes{counts.active, counts.issued * static_cast<std::uint64_t>(place.width())};
  const auto micropolygons = place.run().counter("micropolygons_rasterized");
  row.set("issued", count_text(counts.issued));
  row.set("active", count_text(counts.active));
  row.set("overhead_issued", count_text(counts.overhead_issued));
  row.set("overhead_active", count_text(counts.overhead_active));
  row.set("utilization", number_text(lanes.value()));
  row.set("issued_per_micropolygon",
          number_text(micropolygons ? Ratio{counts.issued, *micropolygons}.value() : std::nullopt));
}

void set_observation(RowWriter& row, const RunRecord& run) {
  row.set("packets", count_text(run.observation.packets));
  row.set("packets_observed", count_text(run.observation.packets_observed));
}

void add_instruction_rows(TidyTable& table, const Place& place) {
  for (const StageRecord& stage : place.run().stages)
    for (const InstructionRecord& counts : stage.instructions) {
      const auto& entries = place.source.report.instructions;
      const auto entry = std::find_if(entries.begin(), entries.end(),
                                      [&](const auto& e) { return e.mnemonic == counts.mnemonic; });
      RowWriter row(table);
      set_parameters(row, place);
      row.set("stage", stage.name);
      row.set("mnemonic", counts.mnemonic);
      row.set("class", entry == entries.end() ? "" : entry->instruction_class);
      row.set("charge", entry == entries.end() ? "" : entry->charge);
      set_counts(row, counts, place);
    }
}

MemoryRecord memory_total(const StageRecord& stage) {
  MemoryRecord sum;
  for (const MemoryRecord& memory : stage.memory) {
    sum.issued += memory.issued;
    sum.active += memory.active;
    sum.lines += memory.lines;
    sum.conflicts += memory.conflicts;
  }
  return sum;
}

void add_stage_rows(TidyTable& table, const Place& place) {
  const bool observed = place.run().observation.packets_observed > 0;
  for (const StageRecord& stage : place.run().stages) {
    const MemoryRecord memory = memory_total(stage);
    const auto observation = [&](std::uint64_t sum) { return observed ? count_text(sum) : ""; };
    RowWriter row(table);
    set_parameters(row, place);
    row.set("stage", stage.name);
    set_counts(row, stage.total(), place);
    set_observation(row, place.run());
    row.set("memory_issued", observation(memory.issued));
    row.set("memory_active", observation(memory.active));
    row.set("memory_lines", observation(memory.lines));
    row.set("memory_conflicts", observation(memory.conflicts));
  }
}

void add_run_row(TidyTable& table, const Place& place) {
  const RunRecord& run = place.run();
  RowWriter row(table);
  set_parameters(row, place);
  row.set("thesis_like", switch_text(run.thesis_like));
  row.set("scene_hash", tidy_hash(run.scene_hash));
  row.set("hits_hash", tidy_hash(run.hits_hash));
  row.set("frame_hash", tidy_hash(run.frame_hash));
  row.set("samples_covered", count_text(run.samples_covered));
  set_observation(row, run);
  row.set("kernel_ms", number_text(place.source.report.timing.kernel_ms[place.index]));
  if (!run.stages.empty()) set_counts(row, total(run, Stages::kAll), place);
  for (const CounterRecord& counter : run.counters)
    row.set(counter.name, count_text(counter.value));
  for (const MetricRecord& metric : run.metrics)
    row.set(metric.name, number_text(counter_ratio(run, metric.numerator, metric.denominator)));
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
  TidyTable table;
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
