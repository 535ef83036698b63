// SPDX-License-Identifier: MIT
// `lanescope run`: one experiment of the user's.
#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/cli/run_summary.h"
#include "analysis/experiment/experiment.h"
#include "analysis/formats/format.h"
#include "analysis/report/report_json.h"

namespace lanescope {
namespace {

struct Arguments {
  ExperimentArguments experiment;
  std::string kernel = "lockstep,repack";
  std::string width;
  std::string micropolygon = "triangle";
  std::string json;
};

void run(const CLI::App& app, const Arguments& arguments) {
  const std::vector<Configuration> configurations = cross(
      resolve_scenes(arguments.experiment, DefaultScenes::kFirst),
      resolve_kernels(arguments.kernel), arguments.width, resolve_shapes(arguments.micropolygon));
  ExperimentOptions options;
  options.threads = resolve_threads(arguments.experiment);
  Destination json(arguments.json);
  Progress progress(app.get_name());
  options.progress = [&](double fraction) { progress.update(fraction); };
  Report report = run_experiment(configurations, options);
  report.command = command_of(app);
  json.write(report_text(report));
  if (!json.is_stdout()) print(find_format("text").write(run_summaries(report)));
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  const auto add = [&](const char* option, std::string& text, const char* form,
                       const char* meaning) {
    return app.add_option(option, text, meaning)->type_name(form)->group("Kernels");
  };
  add("--kernel", arguments->kernel, "NAMES", "Kernels, separated by commas")
      ->default_str(arguments->kernel);
  add("--width", arguments->width, "WS", "Widths of the machine; 8,16,32,64 if left out");
  add("--micropolygon", arguments->micropolygon, "KINDS", "triangle, quad or both")
      ->default_str(arguments->micropolygon);
  add_experiment_options(app, arguments->experiment);
  app.add_option("--json", arguments->json, "Writes the report; - for standard output")
      ->type_name("FILE")
      ->group("Output");
  return [&app, arguments] { run(app, *arguments); };
}

}  // namespace

extern const Command c_run{
    "run", "Runs kernels on scenes and prints how busy the lanes are",
    "  lanescope run --kernel repack --scene teapot --width 16\n"
    "  lanescope run --scene thesis --micropolygon triangle,quad --json report.json\n"
    "  lanescope run --mesh bunny.obj --patches pn --resolution 640x480\n"
    "  lanescope run --kernel repack --stream-load-threshold 0.5 --drain 4000",
    declare};

}  // namespace lanescope
