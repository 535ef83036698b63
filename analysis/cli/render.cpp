// SPDX-License-Identifier: MIT
// `lanescope render`: a picture of a scene, drawn by a kernel, or of what happens at its samples.
#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/cli/values.h"
#include "analysis/experiment/experiment.h"
#include "analysis/experiment/sample_maps.h"
#include "analysis/pictures/heat_map.h"
#include "analysis/pictures/image.h"
#include "analysis/pictures/picture_title.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

enum class Show { kFrame, kTests, kHits, kMicropolygons };

constexpr std::array<Choice<Show>, 4> kShows{{{"frame", Show::kFrame},
                                              {"tests", Show::kTests},
                                              {"hits", Show::kHits},
                                              {"micropolygons", Show::kMicropolygons}}};

struct Arguments {
  ExperimentArguments experiment;
  std::string show = "frame";
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

std::string frame_png(const Configuration& configuration, const ExperimentOptions& asked) {
  std::string bytes;
  ExperimentOptions options = asked;
  options.on_frame = [&](const FinishedFrame& finished) {
    bytes = png(resolve(finished.frame, finished.background));
  };
  run_experiment({configuration}, options);
  return bytes;
}

std::string counts_png(const Configuration& c, const ExperimentOptions& options,
                       SampleCounter::What what) {
  const SampleGrid grid = c.sample_grid();
  SampleCounter counter(grid, what);
  watch_samples(c, counter, options.threads, options.progress);
  const bool tests = what == SampleCounter::What::kTests;
  const auto samples = static_cast<std::uint64_t>(grid.samples_per_pixel());
  return heat_map_png({grid.width_px(), grid.height_px(), pixel_sums(grid, counter.counts()),
                       tests ? 1 : samples,
                       fmt::format("{}: {}", picture_title(c), tests ? "tests" : "hits"),
                       tests ? "tests per pixel" : "hits per sample"});
}

std::string micropolygons_png(const Configuration& c, const ExperimentOptions& options) {
  const SampleGrid grid = c.sample_grid();
  VisibleMicropolygons visible(grid);
  watch_samples(c, visible, options.threads, options.progress);
  return png(micropolygon_picture(grid, visible));
}

std::string picture_png(Show show, const Configuration& c, const ExperimentOptions& options) {
  switch (show) {
    case Show::kFrame:
      return frame_png(c, options);
    case Show::kTests:
      return counts_png(c, options, SampleCounter::What::kTests);
    case Show::kHits:
      return counts_png(c, options, SampleCounter::What::kHits);
    case Show::kMicropolygons:
      return micropolygons_png(c, options);
  }
  return {};
}

/// Kernels, widths and modes differ in how they draw a frame, and in nothing else that is shown.
void refuse_kernel_options(const CLI::App& app, std::string_view show) {
  for (const char* option : {"--kernel", "--width", "--mode"})
    if (app.get_option(option)->count() > 0)
      throw InputError(option, "does not change {}; leave it out, or use --show frame", show);
}

void render(const CLI::App& app, const Arguments& arguments) {
  const Show show = parse_choice({"--show", arguments.show}, kShows);
  if (show != Show::kFrame) refuse_kernel_options(app, arguments.show);
  const Configuration configuration = resolve(arguments);
  if (arguments.output.empty()) throw InputError("--output", "is missing; name a PNG file");
  ExperimentOptions options;
  options.threads = resolve_threads(arguments.experiment);
  Destination picture(arguments.output);
  Progress progress(app.get_name());
  options.progress = [&](double fraction) { progress.update(fraction); };
  picture.write(picture_png(show, configuration, options));
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
  app.add_option("--show", arguments->show,
                 "frame; or tests (sum of each pixel) or hits (mean of its samples) as heat maps; "
                 "or the visible micropolygons, a pixel for each sample")
      ->type_name("WHAT")
      ->default_str(arguments->show)
      ->group("Output");
  app.add_option("-o,--output", arguments->output, "The picture, a PNG file; - for standard output")
      ->type_name("FILE")
      ->group("Output");
  return [&app, arguments] { render(app, *arguments); };
}

}  // namespace

extern const Command c_render{
    "render", "Draws a scene, or what happens at its samples, into a PNG file",
    "  lanescope render --scene teapot -o teapot.png\n"
    "  lanescope render --mesh bunny.obj --msaa 16 -o bunny.png\n"
    "  lanescope render --scene teapot --show tests -o tests.png\n"
    "  lanescope render --scene teapot --show micropolygons --dice-area 64 -o grid.png",
    declare};

}  // namespace lanescope
