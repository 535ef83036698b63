// SPDX-License-Identifier: MIT
// `lanescope run`: one experiment of the user's.
#include <memory>

#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/narrated_experiment.h"
#include "analysis/cli/output.h"
#include "analysis/formats/format.h"
#include "analysis/html/page.h"
#include "analysis/report/report_json.h"
#include "analysis/studies/study.h"
#include "analysis/tables/run_summary.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Given {
  ExperimentArguments experiment;
  std::string threads;
  std::string json;
  std::string html;
};

/// The page of this one report; frames that were drawn before stand where the command runs.
std::string page_of(const Report& report) {
  return report_page({{"report.json", report}}, ".",
                     [](const Report& setting) { return page_plan(setting, studies()); });
}

void run(const CommandOptions& command, const Given& given) {
  const std::vector<Configuration> configurations = resolve_configurations(given.experiment);
  ExperimentOptions options;
  options.threads = parse_threads(given.threads);
  if (given.json == "-" && given.html == "-")
    throw InputError("--html", "standard output is taken by --json; name a file");
  Destination json(given.json);
  Destination html(given.html);
  Narration narration(command.name());
  Report report = run_narrated(narration, configurations, options);
  report.command = command.command_line();
  make_all({[&] { json.write(report_text(report)); },
            [&] {
              if (!html.is_none()) html.write(page_of(report));
            },
            [&] {
              if (!json.is_stdout() && !html.is_stdout())
                print(find_format("text").write(run_summaries(report)));
            }});
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  add_experiment_options(options, given->experiment);
  add_threads_option(options, given->threads);
  options.add_output({"--json", "FILE", "Writes the report; - for standard output"}, given->json);
  options.add_output(
      {"--html", "FILE", "Writes the page of `lanescope report`; - for standard output"},
      given->html);
  return [&options, given] { run(options, *given); };
}

}  // namespace

extern const Command c_run{"run", "Runs kernels on scenes and prints how busy the lanes are",
                           "  lanescope run --kernel {kernel} --scene {scene} --width 16\n"
                           "  lanescope run --kernel {kernel} --width 1:64 --json widths.json\n"
                           "  lanescope run --scene {group} {facet} --json report.json\n"
                           "  lanescope run --kernel {kernel} --width 8,16 --html page.html\n"
                           "  lanescope run --mesh {file}",
                           declare};

}  // namespace lanescope
