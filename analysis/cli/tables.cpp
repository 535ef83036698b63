// SPDX-License-Identifier: MIT
// `lanescope tables`: the experiment of the thesis and its tables, from a new run or from a report.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <set>

#include "analysis/base/json_text.h"
#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/cli/values.h"
#include "analysis/experiment/experiment.h"
#include "analysis/formats/format.h"
#include "analysis/pictures/image.h"
#include "analysis/report/report_json.h"
#include "analysis/tables/thesis_json.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr std::string_view kJson = "json";

struct Arguments {
  ExperimentArguments experiment;
  std::string from;
  std::string format = "text";
  std::vector<std::string> tables;
  bool per_scene = false;
  std::string json;
  std::string out;
};

/// What is asked for, checked before any work.
struct Request {
  std::string format;
  std::vector<const Table*> tables;
  bool per_scene;
};

Request resolve(const Arguments& arguments) {
  std::vector<std::string> names = names_of(formats());
  names.emplace_back(kJson);
  Request request{
      parse_name({"--format", arguments.format}, "a format", names), {}, arguments.per_scene};
  for (const std::string& wanted : arguments.tables) {
    const std::string name = parse_name({"--table", wanted}, "a table", names_of(tables()));
    for (const Table* table : tables())
      if (table->name == name) request.tables.push_back(table);
  }
  if (request.format == kJson && (request.per_scene || !request.tables.empty()))
    throw InputError("--format",
                     "json holds all tables of the mean; leave out --table and --per-scene");
  if (request.tables.empty()) request.tables = tables();
  return request;
}

std::vector<TableData> build(const Request& request, const Report& report) {
  std::vector<TableData> data;
  for (const Table* table : request.tables) data.push_back(build_table(*table, ReportView(report)));
  if (!request.per_scene) return data;
  for (const std::string& scene : scenes_of(report))
    for (const Table* table : request.tables)
      data.push_back(build_table(*table, ReportView(report, scene)));
  return data;
}

std::string document(const Request& request, const Report& report) {
  if (request.format == kJson) return json_text(thesis_json(ReportView(report)));
  return find_format(request.format).write(build(request, report));
}

/// Every scene with both kernels on both kinds of micropolygon at the thesis's widths.
std::vector<Configuration> thesis_experiment(const ExperimentArguments& arguments) {
  return cross(resolve_scenes(arguments, DefaultScenes::kAll), {"lockstep", "repack"}, "",
               {Micropolygon::kTriangle, Micropolygon::kQuad});
}

/// Writes the first frame of each scene as soon as it is there.
class Pictures {
 public:
  explicit Pictures(std::string directory) : directory_(std::move(directory)) {}
  void take(const FinishedFrame& finished) {
    if (directory_.empty() || !drawn_.insert(finished.configuration.scene).second) return;
    write_file(fmt::format("{}/{}", directory_, picture_name(finished.configuration)),
               png(resolve(finished.frame, finished.background)));
  }

 private:
  std::string directory_;
  std::set<std::string> drawn_;
};

Report make_report(const CLI::App& app, const Arguments& arguments) {
  const std::vector<Configuration> configurations = thesis_experiment(arguments.experiment);
  ExperimentOptions options;
  options.threads = resolve_threads(arguments.experiment);
  if (!arguments.out.empty()) make_directory(arguments.out);
  Pictures pictures(arguments.out);
  Progress progress(app.get_name());
  options.progress = [&](double fraction) { progress.update(fraction); };
  options.on_frame = [&](const FinishedFrame& finished) { pictures.take(finished); };
  Report report = run_experiment(configurations, options);
  report.command = command_of(app);
  return report;
}

/// Report and tables in every format, with each scene by itself.
void write_directory(const std::string& directory, const Report& report) {
  write_file(directory + "/report.json", report_text(report));
  write_file(directory + "/tables.json", json_text(thesis_json(ReportView(report))));
  const std::vector<TableData> data = build({"", tables(), true}, report);
  for (const Format* format : formats())
    write_file(fmt::format("{}/tables.{}", directory, format->extension), format->write(data));
}

void tell_end(const Arguments& arguments, const Report& report) {
  std::string text =
      fmt::format("lanescope: {} runs took {:.1f} s on {} threads", report.runs.size(),
                  report.timing.wall_ms / 1000.0, report.timing.threads);
  if (!arguments.out.empty()) text += fmt::format("; results are in {}/", arguments.out);
  std::fputs((text + '\n').c_str(), stderr);
}

void run(const CLI::App& app, const Arguments& arguments) {
  const Request request = resolve(arguments);
  const bool from_file = !arguments.from.empty();
  Destination json(arguments.json);
  const Report report = from_file ? read_report(arguments.from) : make_report(app, arguments);
  const std::string text = document(request, report);
  json.write(report_text(report));
  if (!arguments.out.empty()) {
    make_directory(arguments.out);
    write_directory(arguments.out, report);
  }
  if (!json.is_stdout()) print(text);
  if (!from_file) tell_end(arguments, report);
}

void add_output_options(CLI::App& app, Arguments& arguments) {
  const auto add = [&](const char* option, std::string& text, const char* form,
                       const char* meaning) {
    return app.add_option(option, text, meaning)->type_name(form)->group("Output");
  };
  add("--format", arguments.format, "FORMAT", "text, markdown, csv, latex or json")
      ->default_str(arguments.format);
  app.add_option("--table", arguments.tables, "Only this table (lanescope list tables); repeatable")
      ->type_name("NAME")
      ->type_size(1)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Output");
  app.add_flag("--per-scene", arguments.per_scene, "Also the tables of each scene by itself")
      ->group("Output");
  add("--json", arguments.json, "FILE", "Writes the report; - for standard output, without tables");
  add("--out", arguments.out, "DIR", "Writes report, tables in all formats, and pictures there");
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  add_experiment_options(app, arguments->experiment);
  CLI::Option* from =
      app.add_option("--from", arguments->from, "Reads a report instead of running the experiment")
          ->type_name("FILE")
          ->group("Output");
  for (CLI::Option* option : app.get_options())
    if (option != from && option != app.get_help_ptr()) from->excludes(option);
  add_output_options(app, *arguments);
  return [&app, arguments] { run(app, *arguments); };
}

}  // namespace

extern const Command c_tables{
    "tables", "Runs the experiment of the thesis and prints its tables beside ours",
    "  lanescope tables --out out\n"
    "  lanescope tables --resolution 432x270 --table deviation\n"
    "  lanescope tables --from out/report.json --format latex --per-scene\n"
    "  lanescope tables --from out/report.json --format json",
    declare};

}  // namespace lanescope
