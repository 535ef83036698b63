// SPDX-License-Identifier: MIT
// `lanescope trace`: every instruction of a window of a scene, as pictures and texts.
#include "analysis/trace/trace.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/cli/values.h"
#include "analysis/trace/chrome_trace.h"
#include "analysis/trace/lane_strip_picture.h"
#include "analysis/trace/listing.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// Batches as most are, in most scenes: they are neither at the frame's edge nor facing away.
constexpr const char* kDefaultBatches = "400:404";
constexpr int kMaxBatch = 1 << 30;

struct Arguments {
  ExperimentArguments experiment;
  std::string kernel = "lockstep,repack";
  std::string width = "16";
  std::string micropolygon = "triangle";
  std::string batches;
  std::string region;
  std::string png;
  std::string svg;
  std::string chrome;
  std::string listing;
};

std::vector<Configuration> resolve(const Arguments& arguments) {
  const std::vector<std::string> kernels = resolve_kernels(arguments.kernel);
  const std::vector<Configuration> all =
      cross(resolve_scenes(arguments.experiment, DefaultScenes::kFirst), kernels, arguments.width,
            resolve_shapes(arguments.micropolygon));
  if (all.size() != kernels.size())
    throw InputError("trace", "shows one scene at a time; give one scene, width and micropolygon");
  return all;
}

/// The parts of a text around the first `separator`; fails if there is none.
std::pair<Argument, Argument> split(const Argument& argument, char separator,
                                    std::string_view expected) {
  const std::size_t place = argument.text.find(separator);
  if (place == argument.text.npos) argument.fail(expected);
  return {{argument.option, argument.text.substr(0, place)},
          {argument.option, argument.text.substr(place + 1)}};
}

void parse_batches(const std::string& text, TraceWindow& window) {
  const Argument argument{"--batches", text};
  const auto [first, end] = split(argument, ':', "of the form M:N, as 400:404");
  window.first_batch = static_cast<std::uint64_t>(parse_integer(first, 0, kMaxBatch));
  window.end_batch = static_cast<std::uint64_t>(parse_integer(end, 0, kMaxBatch));
  if (window.first_batch >= window.end_batch)
    throw InputError("--batches", "{} holds no batch; M:N is from M to N - 1", text);
}

Region parse_region(const std::string& text) {
  constexpr std::string_view kForm = "of the form X,Y,WxH, as 800,500,64x64";
  constexpr int kMaxPixel = 16384;
  const auto [x, rest] = split({"--region", text}, ',', kForm);
  const auto [y, size] = split(rest, ',', kForm);
  const auto [width, height] = split(size, 'x', kForm);
  return {parse_integer(x, 0, kMaxPixel), parse_integer(y, 0, kMaxPixel),
          parse_integer(width, 1, kMaxPixel), parse_integer(height, 1, kMaxPixel)};
}

TraceWindow resolve_window(const Arguments& arguments) {
  TraceWindow window;
  if (!arguments.region.empty()) window.region = parse_region(arguments.region);
  if (!arguments.batches.empty())
    parse_batches(arguments.batches, window);
  else if (!window.region)
    parse_batches(kDefaultBatches, window);
  return window;
}

/// The files that were asked for, and what makes them.
class Outputs {
 public:
  explicit Outputs(const Arguments& arguments)
      : png_(arguments.png),
        svg_(arguments.svg),
        chrome_file_(arguments.chrome),
        listing_file_(arguments.listing) {
    if (!png_.is_none() || !svg_.is_none()) sinks_.push_back(&strips_);
    if (!chrome_file_.is_none()) sinks_.push_back(&chrome_);
    if (!listing_file_.is_none()) sinks_.push_back(&listing_);
    if (sinks_.empty())
      throw InputError("trace", "writes nothing; give --png, --svg, --chrome or --listing");
    if (png_.is_stdout() + svg_.is_stdout() + chrome_file_.is_stdout() + listing_file_.is_stdout() >
        1)
      throw InputError("trace", "only one output can go to standard output");
  }

  std::span<TraceSink* const> sinks() const { return sinks_; }

  /// All files appear once everything has been traced.
  void write() {
    if (!png_.is_none())
      png_.write(lane_strip_picture(strips_.at_one_scale(), PictureFormat::kPng));
    if (!svg_.is_none())
      svg_.write(lane_strip_picture(strips_.at_one_scale(), PictureFormat::kSvg));
    if (!chrome_file_.is_none()) {
      chrome_.finish();
      chrome_file_.write();
    }
    listing_file_.write();
  }

 private:
  Destination png_, svg_, chrome_file_, listing_file_;
  LaneStrips strips_;
  ChromeTrace chrome_{[this](std::string_view text) { chrome_file_.append(text); }};
  Listing listing_{[this](std::string_view text) { listing_file_.append(text); }};
  std::vector<TraceSink*> sinks_;
};

void run(const CLI::App& app, const Arguments& arguments) {
  const std::vector<Configuration> configurations = resolve(arguments);
  const TraceWindow window = resolve_window(arguments);
  Outputs outputs(arguments);
  Progress progress(app.get_name());
  for (std::size_t i = 0; i < configurations.size(); ++i)
    trace(configurations[i], window, outputs.sinks(), [&](double fraction) {
      progress.update((static_cast<double>(i) + fraction) /
                      static_cast<double>(configurations.size()));
    });
  outputs.write();
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  const auto add = [&](const char* group, const char* option, std::string& text, const char* form,
                       const char* meaning) {
    CLI::Option* added = app.add_option(option, text, meaning)->type_name(form)->group(group);
    if (!text.empty()) added->default_str(text);
    return added;
  };
  add("Window", "--batches", arguments->batches, "M:N",
      "Batches M to N - 1 of W micropolygons, in the order of the tessellator")
      ->default_str(kDefaultBatches);
  add("Window", "--region", arguments->region, "X,Y,WxH",
      "Only micropolygons that meet these pixels; all batches of them unless --batches is given");
  add("Kernels", "--kernel", arguments->kernel, "NAMES", "Kernels, separated by commas");
  add("Kernels", "--width", arguments->width, "W", "Width of the machine");
  add("Kernels", "--micropolygon", arguments->micropolygon, "KIND", "triangle or quad");
  add_experiment_options(app, arguments->experiment);
  // A trace has its own mode, runs on one thread, and observes everything.
  for (const char* option : {"--mode", "--threads", "--observe-every"})
    app.remove_option(app.get_option(option));
  add("Output", "--png", arguments->png, "FILE", "The lanes over time, as a picture");
  add("Output", "--svg", arguments->svg, "FILE", "The same as lines and areas, for papers");
  add("Output", "--chrome", arguments->chrome, "FILE",
      "Slices of the stages, for Perfetto and speedscope (JSON)");
  add("Output", "--listing", arguments->listing, "FILE",
      "A line for each instruction; - for standard output");
  return [&app, arguments] { run(app, *arguments); };
}

}  // namespace

extern const Command c_trace{
    "trace", "Shows every instruction of a few batches, lane by lane",
    "  lanescope trace --scene teapot --png lanes.png --svg lanes.svg\n"
    "  lanescope trace --scene tigerjump --batches 1000:1200 --png lanes.png\n"
    "  lanescope trace --scene teapot --region 40,30,8x8 --chrome trace.json\n"
    "  lanescope trace --kernel repack --width 8 --batches 400:401 --listing -",
    declare};

}  // namespace lanescope
