// SPDX-License-Identifier: MIT
// `lanescope annotate`: kernel sources with what was issued at each line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "analysis/annotation/annotation.h"
#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/cli/values.h"
#include "analysis/experiment/experiment.h"
#include "analysis/formats/format.h"
#include "analysis/report/report_json.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Arguments {
  ExperimentArguments experiment;
  std::string from;
  std::string kernel;
  std::string width;
  std::string micropolygon;
  std::string hottest = "20";
  std::string format = "text";
  bool source = false;
};

constexpr int kMaxLines = 100000;

/// Whether a word is in a list, or the list was left out.
bool is_wanted(const std::string& list, std::string_view option, std::string_view word) {
  if (list.empty()) return true;
  const std::vector<Argument> elements = parse_list({option, list});
  return std::any_of(elements.begin(), elements.end(),
                     [&](const Argument& element) { return element.text == word; });
}

/// The runs of a report that the options ask for.
Report selected(Report report, const Arguments& a) {
  std::erase_if(report.runs, [&](const RunRecord& run) {
    const Configuration& c = run.configuration;
    return !is_wanted(a.kernel, "--kernel", c.kernel) ||
           !is_wanted(a.width, "--width", std::to_string(c.width)) ||
           !is_wanted(a.micropolygon, "--micropolygon", name_of(kShapes, c.shape())) ||
           !is_wanted(a.experiment.scene, "--scene", c.scene);
  });
  return report;
}

Report run_selected(const CLI::App& app, const Arguments& a) {
  const std::vector<std::string> names = resolve_kernels(a.kernel.empty() ? "repack" : a.kernel);
  const std::vector<Configuration> configurations = cross(
      resolve_scenes(a.experiment, DefaultScenes::kFirst), names, a.width.empty() ? "16" : a.width,
      resolve_shapes(a.micropolygon.empty() ? "triangle" : a.micropolygon));
  ExperimentOptions options;
  options.threads = resolve_threads(a.experiment.threads);
  Progress progress(app.get_name());
  options.progress = [&](double fraction) { progress.update(fraction); };
  return run_experiment(configurations, options);
}

void annotate_sources(const CLI::App& app, const Arguments& a) {
  const int hottest = parse_integer({"--hottest", a.hottest}, 1, kMaxLines);
  const Format& format =
      find_format(parse_name({"--format", a.format}, "a format", names_of(formats())));
  const bool from_file = !a.from.empty();
  const Report report = from_file ? selected(read_report(a.from), a) : run_selected(app, a);
  const std::vector<Annotation> annotations = annotate(report);
  if (annotations.empty())
    throw InputError(from_file ? a.from : "--observe-every",
                     "no run that was asked for has observed source lines; run it with "
                     "--observe-every 1, in counting mode");
  std::vector<TableData> data;
  for (const Annotation& annotation : annotations)
    data.push_back(hottest_lines(annotation, static_cast<std::size_t>(hottest)));
  print(format.write(data));
  if (!a.source) return;
  for (const Annotation& annotation : annotations)
    print(fmt::format("\n{}\n\n{}", annotation.title(), annotated_source(annotation)));
}

Action declare(CLI::App& app) {
  const auto a = std::make_shared<Arguments>();
  CLI::Option* from = app.add_option("--from", a->from, "Reads a report instead of running kernels")
                          ->type_name("FILE")
                          ->group("Output");
  add_experiment_options(app, a->experiment);
  for (CLI::Option* option : app.get_options())
    if (option != from && option != app.get_help_ptr() && option->get_name() != "--scene")
      from->excludes(option);
  const auto add = [&](const char* option, std::string& text, const char* group, const char* form,
                       const char* meaning) {
    CLI::Option* added = app.add_option(option, text, meaning)->type_name(form)->group(group);
    if (!text.empty()) added->default_str(text);
  };
  add("--kernel", a->kernel, "Kernels", "NAMES", "Kernels; repack, or all of the report");
  add("--width", a->width, "Kernels", "WS", "Widths; 16, or all of the report");
  add("--micropolygon", a->micropolygon, "Kernels", "KINDS", "triangle, quad or both");
  add("--hottest", a->hottest, "Output", "N", "Lines in the table of the hottest");
  add("--format", a->format, "Output", "FORMAT", "Of the table: text, markdown, csv or latex");
  app.add_flag("--source", a->source, "Also the whole sources, annotated")->group("Output");
  return [&app, a] { annotate_sources(app, *a); };
}

}  // namespace

extern const Command c_annotate{
    "annotate", "Shows at which lines of a kernel instructions are issued, hottest first",
    "  lanescope annotate --kernel repack --width 16 --scene teapot\n"
    "  lanescope annotate --from out/report.json --kernel lockstep --width 8 --source",
    declare};

}  // namespace lanescope
