// SPDX-License-Identifier: MIT
// `lanescope annotate`: kernel sources with what was issued at each line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/annotation/annotation.h"
#include "analysis/cli/defaults.h"
#include "analysis/cli/input.h"
#include "analysis/cli/narrated_experiment.h"
#include "analysis/cli/output.h"
#include "analysis/cli/selection.h"
#include "analysis/formats/format.h"

namespace lanescope {
namespace {

constexpr int kMaxLines = 100000;
constexpr std::uint64_t kUsualWidth = 16;

struct Given {
  ExperimentArguments experiment;
  std::string threads;
  std::string from;
  std::string hottest = "20";
  std::string format = "text";
  bool source = false;
};

Report run_selected(const CommandOptions& command, const Given& given) {
  const std::vector<Configuration> configurations = resolve_configurations(given.experiment);
  ExperimentOptions options;
  options.threads = parse_threads(given.threads);
  Narration narration(command.name());
  return run_narrated(narration, configurations, options);
}

void annotate_sources(const CommandOptions& command, const Given& given) {
  const int hottest = parse_integer({"--hottest", given.hottest}, 1, kMaxLines);
  const Format& format =
      find_format(parse_name({"--format", given.format}, "a format", names_of(formats())));
  const bool from_file = !given.from.empty();
  const Report report = from_file ? selected(read_reports({given.from}).front(), given.experiment)
                                  : run_selected(command, given);
  const std::vector<Annotation> annotations = annotate(report);
  if (annotations.empty())
    throw InputError(from_file ? given.from : "--observe-every",
                     "no run that was asked for has observed source lines; run it with "
                     "--observe-every 1, in counting mode");
  std::vector<TableData> data;
  for (const Annotation& annotation : annotations)
    data.push_back(hottest_lines(annotation, static_cast<std::size_t>(hottest)));
  print(format.write(data));
  if (!given.source) return;
  for (const Annotation& annotation : annotations)
    print(fmt::format("\n{}\n\n{}", annotation.title(), annotated_source(annotation)));
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  given->experiment.defaults = {{std::string(kWidth), {kUsualWidth}}};
  given->experiment.several = false;
  given->experiment.takes_last_kernel = true;
  add_threads_option(options, given->threads);
  options.exclude_all_before(options.add_output(
      {"--from", "FILE",
       "Reads a report instead of running kernels; parameters then select among its runs"},
      given->from));
  add_experiment_options(options, given->experiment);
  options.add_output({"--hottest", "N", "Lines in the table of the hottest"}, given->hottest);
  options.add_output({"--format", "FORMAT", "Of the table: " + list_or(names_of(formats()))},
                     given->format);
  options.add_output_flag("--source", "Also the whole sources, annotated", given->source);
  return [&options, given] { annotate_sources(options, *given); };
}

}  // namespace

extern const Command c_annotate{
    "annotate", "Shows at which lines of a kernel instructions are issued, hottest first",
    "  lanescope annotate --kernel {kernel} --width 16 --scene {scene}\n"
    "  lanescope annotate --from out/report.json --kernel {kernel} --width 8 --source",
    declare};

}  // namespace lanescope
