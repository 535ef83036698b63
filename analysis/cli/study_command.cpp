// SPDX-License-Identifier: MIT
#include "analysis/cli/study_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "analysis/base/json_text.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/narrated_experiment.h"
#include "analysis/cli/output.h"
#include "analysis/cli/table_arguments.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/pictures/heat_map.h"
#include "analysis/pictures/picture_title.h"
#include "analysis/report/report_json.h"

namespace lanescope {
namespace {

struct Given {
  ExperimentArguments experiment;
  std::string threads;
  std::string from;
  TableArguments tables;
  std::string json;
  std::string out;
};

/// The word for all figures of a study as one document; empty if it has none.
std::string own_format(const Study& study) { return study.figures ? "json" : ""; }

/// Whether some kernel of the study's kind of work takes a parameter.
bool takes(const Study& study, std::string_view parameter) {
  const Workload* const workload = find_kernel(study.kernels.front()).workload;
  return std::any_of(kernels().begin(), kernels().end(), [&](const Kernel* kernel) {
    return kernel->workload == workload && lanescope::takes(*kernel, parameter);
  });
}

/// What the study runs where nothing else is asked for.
ExperimentArguments experiment_of(const Study& study) {
  ExperimentArguments arguments;
  for (const std::string_view kernel : study.kernels)
    arguments.defaults[std::string(kKernel)].emplace_back(std::string(kernel));
  for (const Parameter& parameter : all_parameters())
    if (!takes(study, parameter.name())) arguments.left_out.push_back(parameter.name());
  arguments.defaults[std::string(kScene)] = {std::string("all")};
  for (const Study::Axis& axis : study.axes) {
    const Parameter* const parameter = find_parameter(axis.parameter);
    LANESCOPE_CHECK(parameter, "{} varies '{}', which no kernel takes", study.name, axis.parameter);
    for (const std::string_view value : axis.values)
      arguments.defaults[std::string(axis.parameter)].push_back(
          parse_value(*parameter, value, parameter->words.option));
  }
  return arguments;
}

std::string figures_text(const Study& study, const Report& report) {
  return json_text(study.figures(view_of(study, report)));
}

std::string document(const Study& study, const TableRequest& request, const Report& report) {
  if (!request.format) return figures_text(study, report);
  return request.format->write(build(request, view_of(study, report)));
}

/// Throws InputError for a report that the study has nothing to show of.
Report read_report_for(const Study& study, const std::string& file) {
  Report report = read_report(file);
  if (!study.is_about(report)) throw InputError(file, "has no figures for these tables");
  return report;
}

/// Throws InputError unless some run counts what the tables show.
void require_counting(const std::vector<Configuration>& configurations) {
  const bool counts = std::any_of(
      configurations.begin(), configurations.end(),
      [](const Configuration& configuration) { return configuration.mode != Mode::kUncounted; });
  if (!counts)
    throw InputError("--mode",
                     "{} runs have no figures for tables; leave it out, or use `lanescope run`",
                     name_of(kModes, Mode::kUncounted));
}

/// Writes the first picture of each scene as soon as it is there.
class Pictures {
 public:
  explicit Pictures(std::string directory) : directory_(std::move(directory)) {}
  void take(const FinishedOutput& finished) {
    if (directory_.empty() || drawn_.contains(finished.configuration.scene)) return;
    const std::optional<Raster> picture = finished.output.picture();
    if (!picture) return;
    drawn_.insert(finished.configuration.scene);
    write_file(fmt::format("{}/{}", directory_, picture_name(finished.configuration)),
               raster_png(*picture, picture_title(finished.configuration)));
  }

 private:
  std::string directory_;
  std::set<std::string> drawn_;
};

Report make_report(const CommandOptions& command, const Given& given) {
  const std::vector<Configuration> configurations = resolve_configurations(given.experiment);
  require_counting(configurations);
  ExperimentOptions options;
  options.threads = parse_threads(given.threads);
  if (!given.out.empty()) make_directory(given.out);
  Pictures pictures(given.out);
  options.on_output = [&](const FinishedOutput& finished) { pictures.take(finished); };
  Narration narration(command.name());
  Report report = run_narrated(narration, configurations, options);
  report.command = command.command_line();
  return report;
}

/// Report and tables in every format, with each scene by itself.
void write_directory(const std::string& directory, const Study& study, const Report& report) {
  make_directory(directory);
  write_file(directory + "/report.json", report_text(report));
  if (study.figures) write_file(directory + "/tables.json", figures_text(study, report));
  const std::vector<TableData> data =
      build({nullptr, study.tables(), true}, view_of(study, report));
  for (const Format* format : formats())
    write_file(fmt::format("{}/tables.{}", directory, format->extension), format->write(data));
}

void tell_end(const Given& given, const Report& report) {
  std::string text = fmt::format("{} runs took {:.1f} s on {} threads", report.runs.size(),
                                 report.timing.wall_ms / 1000.0, report.timing.threads);
  if (!given.out.empty()) text += fmt::format("; results are in {}/", given.out);
  tell(text);
}

void run(const CommandOptions& command, const Study& study, const Given& given) {
  const TableRequest request = resolve_tables(given.tables, study.tables(), own_format(study));
  const bool from_file = !given.from.empty();
  Destination json(given.json);
  const Report report =
      from_file ? read_report_for(study, given.from) : make_report(command, given);
  const std::string text = document(study, request, report);
  make_all({[&] { json.write(report_text(report)); },
            [&] {
              if (!given.out.empty()) write_directory(given.out, study, report);
            },
            [&] {
              if (!json.is_stdout()) print(text);
            }});
  if (!from_file) tell_end(given, report);
}

}  // namespace

Action declare_study(CommandOptions& options, const Study& study) {
  const auto given = std::make_shared<Given>();
  given->experiment = experiment_of(study);
  add_experiment_options(options, given->experiment);
  add_threads_option(options, given->threads);
  options.exclude_all_before(options.add_output(
      {"--from", "FILE", "Reads a report instead of running the experiment"}, given->from));
  add_table_options(options, given->tables, own_format(study));
  options.add_output({"--json", "FILE", "Writes the report; - for standard output, without tables"},
                     given->json);
  options.add_output({"--out", "DIR", "Writes report, tables in all formats, and pictures there"},
                     given->out);
  return [&options, &study, given] { run(options, study, *given); };
}

}  // namespace lanescope
