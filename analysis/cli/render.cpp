// SPDX-License-Identifier: MIT
// `lanescope render`: a picture of what a kernel writes, or of something else of its work.
#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/defaults.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/memory_notice.h"
#include "analysis/cli/narration.h"
#include "analysis/cli/output.h"
#include "analysis/experiment/draw.h"
#include "analysis/experiment/experiment.h"
#include "analysis/pictures/heat_map.h"
#include "analysis/pictures/picture_title.h"

namespace lanescope {
namespace {

/// Words for the picture of the output; the second is for those who think of frames.
constexpr std::string_view kOutputs[] = {"output", "frame"};

struct Given {
  ExperimentArguments experiment;
  std::string threads;
  std::string show{kOutputs[0]};
  std::string output;
};

/// What is shown, and the kernel that has it; no view for the output of whatever kernel draws.
struct Shown {
  const View* view = nullptr;
  const Kernel* kernel = nullptr;
};

std::vector<std::string> things_to_show() {
  std::vector<std::string> names(std::begin(kOutputs), std::end(kOutputs));
  for (const Kernel* kernel : kernels())
    for (const View& view : kernel->views) names.emplace_back(view.name);
  return names;
}

Shown find_shown(const std::string& text) {
  const std::vector<std::string> names = things_to_show();
  for (const std::string_view word : kOutputs)
    if (text == word) return {};
  for (const Kernel* kernel : kernels())
    for (const View& view : kernel->views)
      if (view.name == text) return {&view, kernel};
  throw InputError("--show", "'{}' is not {}{}", text, list_or(names), did_you_mean(text, names));
}

/// Kernels, widths and modes differ in how they draw, and in nothing that a view shows.
void refuse_machine_options(const CommandOptions& command, const View& view) {
  for (const char* name : {"kernel", "width_lanes", "mode"}) {
    const std::string option(find_parameter(name)->words.option);
    if (command.is_given(option))
      throw InputError(option, "does not change {}; leave it out, or use --show {}", view.name,
                       kOutputs[0]);
  }
}

Configuration resolve(const CommandOptions& command, const Given& given, const Shown& shown) {
  ExperimentArguments arguments = given.experiment;
  if (shown.view) {
    refuse_machine_options(command, *shown.view);
    arguments.defaults[std::string(kKernel)] = {std::string(shown.kernel->name)};
  }
  const std::vector<Configuration> all = resolve_configurations(arguments);
  if (all.size() != 1)
    throw InputError(
        "render",
        "draws one picture; give one scene, kernel and width, and one value of what else there is");
  return all.front();
}

std::string picture_of(const Output& output, const Configuration& c, const Shown& shown) {
  const std::optional<Raster> picture = output.picture();
  if (!picture)
    throw InputError("--show", "{} of {} is no picture",
                     shown.view ? shown.view->name : kOutputs[0], c.kernel);
  const std::string title = picture_title(c);
  return raster_png(*picture, shown.view ? fmt::format("{}: {}", title, shown.view->name) : title);
}

std::string picture_png(const Configuration& c, const Shown& shown, ExperimentOptions options) {
  if (shown.view)
    return picture_of(*draw(c, *shown.view, options.threads, options.progress, options.opening), c,
                      shown);
  std::string bytes;
  options.on_output = [&](const FinishedOutput& finished) {
    bytes = picture_of(finished.output, c, shown);
  };
  run_experiment({c}, options);
  return bytes;
}

void render(const CommandOptions& command, const Given& given) {
  const Shown shown = find_shown(given.show);
  const Configuration configuration = resolve(command, given, shown);
  if (given.output.empty()) throw InputError("--output", "is missing; name a PNG file");
  ExperimentOptions options;
  options.threads = parse_threads(given.threads);
  Destination picture(given.output);
  if (shown.view)
    tell_memory(shown.view->output_bytes(configuration.arguments));
  else
    tell_memory({configuration});
  Narration progress(command.name());
  options.opening = progress.listener();
  options.progress = [&](double fraction) { progress.update(fraction); };
  picture.write(picture_png(configuration, shown, options));
}

std::string help_of_show() {
  std::string help = fmt::format("{} (or {}) of the kernel", kOutputs[0], kOutputs[1]);
  for (const Kernel* kernel : kernels())
    for (const View& view : kernel->views) help += fmt::format("; {}: {}", view.name, view.summary);
  return help;
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  given->experiment.several = false;
  given->experiment.takes_lists = false;
  given->experiment.defaults["mode"] = {std::string(name_of(kModes, Mode::kUncounted))};
  add_experiment_options(options, given->experiment);
  add_threads_option(options, given->threads);
  options.add("Picture", {"--show", "WHAT", help_of_show()}, given->show);
  options.add_output({"-o,--output", "FILE", "The picture, a PNG file; - for standard output"},
                     given->output);
  return [&options, given] { render(options, *given); };
}

}  // namespace

extern const Command c_render{"render", "Draws a scene, or what happens in it, into a PNG file",
                              "  lanescope render --scene {scene} -o scene.png\n"
                              "  lanescope render --mesh {file} -o model.png\n"
                              "  lanescope render --scene {scene} --show {view} -o view.png",
                              declare};

}  // namespace lanescope
