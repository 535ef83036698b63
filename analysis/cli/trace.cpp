// SPDX-License-Identifier: MIT
// `lanescope trace`: every instruction of a window of a scene, as pictures and texts.
#include "analysis/trace/trace.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/narration.h"
#include "analysis/cli/output.h"
#include "analysis/trace/chrome_trace.h"
#include "analysis/trace/lane_strip_picture.h"
#include "analysis/trace/listing.h"

namespace lanescope {
namespace {

/// Batches as most are: far enough from the beginning of a scene, where work is often unusual.
constexpr const char* kDefaultBatches = "400:404";
constexpr int kMaxBatch = 1 << 30;

constexpr std::uint64_t kUsualWidth = 16;

struct Given {
  ExperimentArguments experiment;
  std::string batches;
  std::string region;
  std::string png;
  std::string svg;
  std::string chrome;
  std::string listing;
};

/// One for each kernel.
std::vector<Configuration> resolve(const Given& given) {
  const std::vector<Configuration> all = resolve_configurations(given.experiment);
  for (std::size_t i = 1; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all[i].kernel == all[j].kernel)
        throw InputError(
            "trace",
            "shows one scene at a time; give one scene and width, and one value of what "
            "else there is");
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

TraceWindow resolve_window(const Given& given) {
  TraceWindow window;
  if (!given.region.empty()) window.region = parse_region(given.region);
  if (!given.batches.empty())
    parse_batches(given.batches, window);
  else if (!window.region)
    parse_batches(kDefaultBatches, window);
  return window;
}

/// The files that were asked for, and what makes them.
class Outputs {
 public:
  explicit Outputs(const Given& given)
      : png_(given.png), svg_(given.svg), chrome_file_(given.chrome), listing_file_(given.listing) {
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
    make_all({[&] { write_strips(png_, PictureFormat::kPng); },
              [&] { write_strips(svg_, PictureFormat::kSvg); },
              [&] {
                if (!chrome_file_.is_none()) chrome_.finish();
                chrome_file_.write();
              },
              [&] { listing_file_.write(); }});
  }

 private:
  void write_strips(Destination& file, PictureFormat format) {
    if (!file.is_none()) file.write(lane_strip_picture(strips_.at_one_scale(), format));
  }

  Destination png_, svg_, chrome_file_, listing_file_;
  LaneStrips strips_;
  ChromeTrace chrome_{[this](std::string_view text) { chrome_file_.append(text); }};
  Listing listing_{[this](std::string_view text) { listing_file_.append(text); }};
  std::vector<TraceSink*> sinks_;
};

void run(const CommandOptions& command, const Given& given) {
  const std::vector<Configuration> configurations = resolve(given);
  const TraceWindow window = resolve_window(given);
  Outputs outputs(given);
  Narration progress(command.name());
  for (std::size_t i = 0; i < configurations.size(); ++i)
    trace(
        configurations[i], window, outputs.sinks(),
        [&](double fraction) {
          progress.update((static_cast<double>(i) + fraction) /
                          static_cast<double>(configurations.size()));
        },
        progress.listener());
  outputs.write();
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  given->experiment.defaults = {{std::string(kWidth), {kUsualWidth}}};
  given->experiment.takes_lists = false;
  // A trace has its own mode, and observes everything.
  given->experiment.left_out = {"mode", "observe_every"};
  options
      .add("Window",
           {"--batches", "M:N",
            "Batches M to N - 1: what a kernel takes at a time, up to W elements of work"},
           given->batches)
      ->default_str(kDefaultBatches);
  options.add(
      "Window",
      {"--region", "X,Y,WxH",
       "Only elements that meet these pixels; all batches of them unless --batches is given"},
      given->region);
  add_experiment_options(options, given->experiment);
  options.add_output({"--png", "FILE", "The lanes over time, as a picture"}, given->png);
  options.add_output({"--svg", "FILE", "The same as lines and areas, for papers"}, given->svg);
  options.add_output(
      {"--chrome", "FILE", "Slices of the stages, for Perfetto and speedscope (JSON)"},
      given->chrome);
  options.add_output({"--listing", "FILE", "A line for each instruction; - for standard output"},
                     given->listing);
  return [&options, given] { run(options, *given); };
}

}  // namespace

extern const Command c_trace{
    "trace", "Shows every instruction of a few batches, lane by lane",
    "  lanescope trace --scene {scene} --png lanes.png --svg lanes.svg\n"
    "  lanescope trace --scene {scene} --batches 300:400 --png lanes.png\n"
    "  lanescope trace --scene {scene} --region 40,30,8x8 --chrome trace.json\n"
    "  lanescope trace --kernel {kernel} --width 8 --batches 400:401 --listing -",
    declare};

}  // namespace lanescope
