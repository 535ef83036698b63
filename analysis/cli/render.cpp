// SPDX-License-Identifier: MIT
// `lanescope render`: a picture of a scene, drawn by a kernel.
#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/experiment.h"
#include "analysis/image.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Arguments {
  ExperimentArguments experiment;
  std::string kernel = "lockstep";
  std::string width;
  std::string micropolygon = "quad";
  std::string output;
  Arguments() { experiment.mode = name_of(kModes, Mode::kUncounted); }
};

Configuration resolve(const Arguments& arguments) {
  const std::vector<std::string> kernels = resolve_kernels(arguments.kernel);
  const std::string width = arguments.width.empty()
                                ? std::to_string(resolve_widths("", kernels.front()).front())
                                : arguments.width;
  const std::vector<Configuration> all =
      cross(resolve_scenes(arguments.experiment, DefaultScenes::kFirst), kernels, width,
            resolve_shapes(arguments.micropolygon));
  if (all.size() != 1)
    throw InputError("render", "draws one picture; give one scene, kernel, width and micropolygon");
  return all.front();
}

void render(const CLI::App& app, const Arguments& arguments) {
  const Configuration configuration = resolve(arguments);
  if (arguments.output.empty()) throw InputError("--output", "is missing; name a PNG file");
  ExperimentOptions options;
  options.threads = resolve_threads(arguments.experiment);
  Destination picture(arguments.output);
  Progress progress(app.get_name());
  options.progress = [&](double fraction) { progress.update(fraction); };
  options.on_frame = [&](const FinishedFrame& finished) {
    picture.write(png(resolve(finished.frame, finished.background)));
  };
  run_experiment({configuration}, options);
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  const auto add = [&](const char* option, std::string& text, const char* form,
                       const char* meaning) {
    CLI::Option* added = app.add_option(option, text, meaning)->type_name(form)->group("Kernels");
    if (!text.empty()) added->default_str(text);
  };
  add("--kernel", arguments->kernel, "NAME", "The kernel that draws");
  add("--width", arguments->width, "W", "Width of its machine; the narrowest if left out");
  add("--micropolygon", arguments->micropolygon, "KIND", "triangle or quad");
  add_experiment_options(app, arguments->experiment);
  app.add_option("-o,--output", arguments->output, "The picture, a PNG file; - for standard output")
      ->type_name("FILE")
      ->group("Output");
  return [&app, arguments] { render(app, *arguments); };
}

}  // namespace

extern const Command c_render{"render", "Draws a scene into a PNG file",
                              "  lanescope render --scene teapot -o teapot.png\n"
                              "  lanescope render --mesh bunny.obj --msaa 16 -o bunny.png",
                              declare};

}  // namespace lanescope
