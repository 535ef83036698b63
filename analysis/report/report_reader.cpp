// SPDX-License-Identifier: MIT
// Reads what report_json.cpp writes, and refuses everything else.
#include <algorithm>
#include <cctype>
#include <set>

#include "analysis/base/files.h"
#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/report_checks.h"
#include "analysis/report/report_json.h"
#include "analysis/report/stage_reader.h"
#include "simulator/memory.h"

namespace lanescope {
namespace {

double read_ms(const JsonCursor& cursor) { return cursor.number_from_0(); }
std::uint64_t read_count(const JsonCursor& cursor) { return cursor.count(); }

CounterRecord read_counter(const JsonCursor& cursor) {
  cursor.require_members({"name", "meaning", "unit", "value"});
  return {read_figure_name(cursor.member("name")), cursor.member("meaning").string(),
          cursor.member("unit").string(), cursor.member("value").count()};
}

SourceRecord read_source(const JsonCursor& cursor) {
  cursor.require_members({"hash", "pieces", "pieces_observed", "counters"});
  require_at_most(cursor.member("pieces_observed"), cursor.member("pieces").count(), "the pieces");
  return {cursor.member("hash").hash(), cursor.member("pieces").count(),
          cursor.member("pieces_observed").count(),
          read_named(cursor.member("counters"), "name", read_counter)};
}

OutputRecord read_output(const JsonCursor& cursor) {
  cursor.require_members({"hash", "counters"});
  return {cursor.member("hash").hash(),
          read_named(cursor.member("counters"), "name", read_counter)};
}

/// Reads the name of one of the run's counters.
std::string read_counter_of(const RunRecord& run, const JsonCursor& cursor) {
  if (!run.counter(cursor.string())) cursor.fail("the name of a counter of this run");
  return cursor.string();
}

ElementRecord read_element(const JsonCursor& cursor, const RunRecord& run) {
  cursor.require_members({"counter", "name", "abbreviation"});
  const JsonCursor counter = cursor.member("counter");
  return {run.counters.empty() ? counter.string() : read_counter_of(run, counter),
          cursor.member("name").string(), cursor.member("abbreviation").string()};
}

MetricRecord read_metric(const JsonCursor& cursor, const RunRecord& run) {
  cursor.require_members({"name", "meaning", "numerator_counter", "denominator_counter", "ratio"});
  const MetricRecord metric{read_figure_name(cursor.member("name")),
                            cursor.member("meaning").string(),
                            read_counter_of(run, cursor.member("numerator_counter")),
                            read_counter_of(run, cursor.member("denominator_counter"))};
  check_ratio(cursor.member("ratio"),
              {*run.counter(metric.numerator), *run.counter(metric.denominator)});
  return metric;
}

SeriesRecord read_series(const JsonCursor& cursor) {
  cursor.require_members({"name", "meaning", "index", "unit", "values"});
  return {read_figure_name(cursor.member("name")), cursor.member("meaning").string(),
          cursor.member("index").string(), cursor.member("unit").string(),
          read_list(cursor.member("values"), read_count)};
}

std::string read_workload(const JsonCursor& cursor, const Configuration& configuration) {
  const Kernel* const kernel = known_kernel(configuration.kernel);
  if (kernel && cursor.string() != kernel->workload->name)
    cursor.fail(
        fmt::format("\"{}\", the kind of work of {}", kernel->workload->name, kernel->name));
  return cursor.string();
}

/// Checks the sums that the run's kernel declares, where it counts all of their counters.
void check_sums(const JsonCursor& counters, const RunRecord& run) {
  const Kernel* const kernel = known_kernel(run.configuration.kernel);
  if (!kernel) return;
  for (const CounterSum& sum : kernel->sums) {
    const auto whole = run.counter(sum.whole);
    std::uint64_t parts = 0;
    bool is_known = whole.has_value();
    for (const std::string_view part : sum.parts) {
      const auto value = run.counter(part);
      is_known = is_known && value;
      parts += value.value_or(0);
    }
    if (!is_known || sum.times * *whole == parts) continue;
    const std::vector<std::string> names(sum.parts.begin(), sum.parts.end());
    for (const JsonCursor& counter : counters.items())
      if (counter.member("name").string() == sum.whole)
        counter.member("value").fail(
            fmt::format("{}, which {} add up to{}", parts / sum.times, list_and(names),
                        sum.times == 1 ? "" : fmt::format(" (over {})", sum.times)));
  }
}

RunRecord read_run(const JsonCursor& cursor, const Charges& charges) {
  cursor.require_members({"parameters", "workload", "source", "element", "stages", "counters",
                          "metrics", "series", "source_lines", "results_hash", "output"});
  RunRecord run;
  run.configuration = read_configuration(cursor.member("parameters"));
  run.workload = read_workload(cursor.member("workload"), run.configuration);
  run.source = read_source(cursor.member("source"));
  run.counters = read_named(cursor.member("counters"), "name", read_counter);
  check_sums(cursor.member("counters"), run);
  run.element = read_element(cursor.member("element"), run);
  run.stages = read_stages(cursor.member("stages"), run.configuration.width, charges);
  run.metrics = read_named(cursor.member("metrics"), "name",
                           [&](const JsonCursor& metric) { return read_metric(metric, run); });
  run.series = read_named(cursor.member("series"), "name", read_series);
  run.source_lines = read_source_lines(cursor.member("source_lines"), run.stages);
  run.results_hash = cursor.member("results_hash").hash();
  run.output = read_output(cursor.member("output"));
  return run;
}

/// One of the words for values of an enum, which to_string gives.
template <class Values>
auto read_word(const JsonCursor& cursor, const Values& values) {
  std::vector<std::string> words;
  for (const auto value : values) words.emplace_back(to_string(value));
  const auto found = std::find(words.begin(), words.end(), cursor.string());
  if (found == words.end()) cursor.fail(list_or(words) + did_you_mean(cursor.string(), words));
  return values[static_cast<std::size_t>(found - words.begin())];
}

InstructionEntry read_entry(const JsonCursor& cursor) {
  cursor.require_members({"mnemonic", "meaning", "class", "charge"});
  return {cursor.member("mnemonic").string(), cursor.member("meaning").string(),
          std::string(to_string(read_word(cursor.member("class"), kInstructionClasses))),
          std::string(to_string(read_word(cursor.member("charge"), kCharges)))};
}

Charges read_charges(const JsonCursor& instructions) {
  Charges charges;
  for (const JsonCursor& entry : instructions.items())
    charges.emplace(entry.member("mnemonic").string(), read_word(entry.member("charge"), kCharges));
  return charges;
}

/// Checks that the dictionary explains nothing but what some run issued.
void check_issued(const JsonCursor& instructions, const Report& report) {
  std::set<std::string> issued;
  for (const RunRecord& run : report.runs)
    for (const StageRecord& stage : run.stages)
      for (const InstructionRecord& counts : stage.instructions) issued.insert(counts.mnemonic);
  for (const JsonCursor& entry : instructions.items())
    if (const JsonCursor mnemonic = entry.member("mnemonic"); !issued.contains(mnemonic.string()))
      mnemonic.fail("the mnemonic of an instruction that some run issued");
}

/// Checks that no two runs are the same.
void check_distinct(const JsonCursor& runs, const Report& report) {
  std::set<std::string> known;
  const std::vector<JsonCursor> items = runs.items();
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!known.insert(configuration_json(report.runs[i].configuration).dump()).second)
      throw InputError(items[i].member("parameters").where(),
                       "are those of an earlier run, too; each run has its own");
}

Timing read_timing(const JsonCursor& cursor, std::size_t runs) {
  cursor.require_members({"wall_ms", "threads", "host", "compiler", "kernel_ms", "source_ms",
                          "observation_ms", "peak_memory_bytes"});
  const Timing timing{cursor.member("wall_ms").number_from_0(),
                      cursor.member("threads").integer(1),
                      cursor.member("host").string(),
                      cursor.member("compiler").string(),
                      read_list(cursor.member("kernel_ms"), read_ms),
                      cursor.member("source_ms").number_from_0(),
                      cursor.member("observation_ms").number_from_0(),
                      cursor.member("peak_memory_bytes").count()};
  if (timing.kernel_ms.size() != runs)
    throw InputError(cursor.member("kernel_ms").where(),
                     "has {} elements; {} are needed, one for each run", timing.kernel_ms.size(),
                     runs);
  return timing;
}

/// The command that made a report of any version, as a message has it; what has none is shown the
/// usual one.
std::string command_of(const JsonCursor& document) {
  constexpr const char* kUsual = "lanescope run --json";
  if (!document.has_member("made_by")) return kUsual;
  const JsonCursor made_by = document.member("made_by");
  if (!made_by.has_member("command") || !made_by.member("command").value().is_string())
    return kUsual;
  const std::string command = made_by.member("command").string();
  const bool is_one_line = std::none_of(command.begin(), command.end(), [](char c) {
    return std::iscntrl(static_cast<unsigned char>(c)) != 0;
  });
  return is_one_line && !command.empty() ? command : kUsual;
}

/// Looks at the version before anything else, as another form may have other members.
void check_schema(const JsonCursor& document) {
  const JsonCursor schema = document.member("schema");
  schema.require_members({"name", "version"});
  if (schema.member("name").string() != kReportSchema)
    schema.member("name").fail(fmt::format("\"{}\"", kReportSchema));
  const JsonCursor version = schema.member("version");
  if (version.integer(1) > kReportVersion)
    throw InputError(version.where(),
                     "version {} is newer than {}, the only one that this program reads",
                     version.integer(1), kReportVersion);
  if (version.integer(1) < kReportVersion)
    throw InputError(version.where(),
                     "version {} is older than {}, the only one that this program reads; make the "
                     "report again, as with `{}`",
                     version.integer(1), kReportVersion, command_of(document));
}

/// Reads who made the report.
void read_made_by(const JsonCursor& cursor, Report& report) {
  cursor.require_members({"program", "version", "commit", "command"});
  if (cursor.member("program").string() != "lanescope")
    cursor.member("program").fail("\"lanescope\"");
  report.program_version = cursor.member("version").string();
  const JsonCursor commit = cursor.member("commit");
  if (!commit.is_null()) {
    report.commit = commit.string();
    if (report.commit.empty()) commit.fail("a commit, or null if it is not known");
  }
  report.command = cursor.member("command").string();
}

/// The machine is the same in every report of a version.
void check_machine(const JsonCursor& machine) {
  machine.require_members({"line_bytes", "element_types"});
  if (machine.member("line_bytes").count() != kLineBytes)
    machine.member("line_bytes").fail(fmt::format("{}", kLineBytes));
  const std::vector<JsonCursor> types = machine.member("element_types").items();
  if (types.size() != kElementTypes.size())
    throw InputError(machine.member("element_types").where(), "has {} elements; {} are needed",
                     types.size(), kElementTypes.size());
  for (std::size_t i = 0; i < types.size(); ++i)
    if (types[i].string() != kElementTypes[i])
      types[i].fail(fmt::format("\"{}\"", kElementTypes[i]));
}

}  // namespace

Report parse_report(std::string_view text, const std::string& where) {
  const nlohmann::ordered_json json = parse_json(text, where);
  const JsonCursor document(json, where);
  check_schema(document);
  document.require_members({"schema", "made_by", "machine", "instructions", "runs", "timing"});
  Report report;
  read_made_by(document.member("made_by"), report);
  check_machine(document.member("machine"));
  report.instructions = read_named(document.member("instructions"), "mnemonic", read_entry);
  const Charges charges = read_charges(document.member("instructions"));
  for (const JsonCursor& run : document.member("runs").items())
    report.runs.push_back(read_run(run, charges));
  check_issued(document.member("instructions"), report);
  check_distinct(document.member("runs"), report);
  report.timing = read_timing(document.member("timing"), report.runs.size());
  return report;
}

Report read_report(const std::string& path) { return parse_report(read_file(path), path); }

}  // namespace lanescope
