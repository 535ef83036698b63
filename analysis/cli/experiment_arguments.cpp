// SPDX-License-Identifier: MIT
#include "analysis/cli/experiment_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "analysis/cli/values.h"
#include "analysis/configuration/configuration_limits.h"
#include "analysis/experiment/scene_source.h"
#include "analysis/tables/thesis.h"

namespace lanescope {
namespace {

constexpr int kMaxThreads = 256;

/// An integer within the limits of a parameter of that name.
int parse_integer_of(std::string_view parameter, const Argument& argument) {
  const Limits& limits = *find_limits(parameter);
  return parse_integer(argument, static_cast<int>(limits.low), static_cast<int>(limits.high));
}

/// A number within the limits of a parameter of that name.
float parse_number_of(std::string_view parameter, const Argument& argument) {
  const Limits& limits = *find_limits(parameter);
  return parse_number(argument, static_cast<float>(limits.low), static_cast<float>(limits.high));
}

void parse_resolution(const std::string& text, TessellationOptions& options) {
  const Argument argument{"--resolution", text};
  const std::size_t cross = text.find('x');
  if (cross == text.npos) argument.fail("of the form WIDTHxHEIGHT, as 1728x1080");
  const std::string_view all = text;
  options.width_px = parse_integer_of("width_px", {argument.option, all.substr(0, cross)});
  options.height_px = parse_integer_of("height_px", {argument.option, all.substr(cross + 1)});
}

void resolve_tessellation(const ExperimentArguments& a, TessellationOptions& options) {
  parse_resolution(a.resolution, options);
  options.dice_area_px = parse_number_of("dice_area_px", {"--dice-area", a.dice_area});
  options.grid_limit = parse_integer_of("grid_limit", {"--grid", a.grid});
  options.packet_capacity = parse_integer_of("packet_capacity", {"--drain", a.drain});
}

void resolve_sampling(const ExperimentArguments& a, Configuration& c) {
  std::vector<std::string> counts;
  for (const int count : kSampleCounts) counts.push_back(std::to_string(count));
  c.samples_per_pixel =
      std::stoi(parse_name({"--msaa", a.msaa}, "a number of samples a pixel", counts));
  c.jitter = parse_choice({"--jitter", a.jitter}, kSwitch);
  c.seed = parse_seed({"--seed", a.seed});
  c.sample_grid();  // Refuses frames that are too large at that many samples.
}

void resolve_kernel_options(const ExperimentArguments& a, Configuration& c) {
  c.options.cull_backfaces = parse_choice({"--cull", a.cull}, kSwitch);
  c.options.edges = parse_choice({"--edges", a.edges}, kEdges);
  c.options.stream_load_threshold = parse_number_of(
      "stream_load_threshold", {"--stream-load-threshold", a.stream_load_threshold});
  c.mode = parse_choice({"--mode", a.mode}, kModes);
  c.observe_every = parse_integer_of("observe_every", {"--observe-every", a.observe_every});
}

std::vector<std::string> scene_names(bool (*wanted)(const SceneDescriptor&)) {
  std::vector<std::string> names;
  for (const SceneDescriptor* scene : scenes())
    if (wanted(*scene)) names.emplace_back(scene->name);
  return names;
}

std::vector<std::string> resolve_scene_names(const std::string& text, DefaultScenes defaults) {
  const auto any = [](const SceneDescriptor&) { return true; };
  const auto like_thesis = [](const SceneDescriptor& scene) { return scene.thesis_like; };
  if (text == "all" || (text.empty() && defaults == DefaultScenes::kAll)) return scene_names(any);
  if (text == "thesis" || (text.empty() && defaults == DefaultScenes::kThesis))
    return scene_names(like_thesis);
  if (text.empty()) return {scene_names(any).front()};
  std::vector<std::string> allowed = scene_names(any);
  std::vector<std::string> names;
  for (const Argument& element : parse_list({"--scene", text})) {
    if (element.text == "all" || element.text == "thesis")
      throw InputError("--scene", "'{}' stands for several scenes; use it alone", element.text);
    names.push_back(parse_name(element, "a scene", allowed));
  }
  return names;
}

int resolve_frame(const std::string& text, const SceneDescriptor& scene) {
  if (text.empty()) return scene.default_frame;
  const int frame = parse_integer_of("frame", {"--frame", text});
  if (frame >= scene.frame_count)
    throw InputError("--frame", "{} is not a frame of {}; use 0 to {}", frame, scene.name,
                     scene.frame_count - 1);
  return frame;
}

void resolve_mesh(const ExperimentArguments& a, Configuration& c) {
  if (!a.frame.empty()) throw InputError("--frame", "a mesh has no frames; leave it out");
  c.scene = a.mesh;
  c.mesh_patches = parse_choice({"--patches", a.patches}, kMeshPatches);
}

}  // namespace

ExperimentArguments::ExperimentArguments() {
  const Configuration c;
  const TessellationOptions& t = c.tessellation;
  resolution = fmt::format("{}x{}", t.width_px, t.height_px);
  dice_area = fmt::format("{}", t.dice_area_px);
  grid = fmt::format("{}", t.grid_limit);
  drain = fmt::format("{}", t.packet_capacity);
  msaa = fmt::format("{}", c.samples_per_pixel);
  jitter = name_of(kSwitch, c.jitter);
  seed = fmt::format("{}", c.seed);
  edges = name_of(kEdges, c.options.edges);
  stream_load_threshold = fmt::format("{}", c.options.stream_load_threshold);
  cull = name_of(kSwitch, c.options.cull_backfaces);
  mode = name_of(kModes, c.mode);
  observe_every = fmt::format("{}", c.observe_every);
}

void add_experiment_options(CLI::App& app, ExperimentArguments& a) {
  const auto add = [&](const char* group, const char* option, std::string& text, const char* form,
                       const char* meaning) {
    CLI::Option* added = app.add_option(option, text, meaning)->group(group)->type_name(form);
    if (!text.empty()) added->default_str(text);
    return added;
  };
  CLI::Option* scene = add("Scene", "--scene", a.scene, "NAMES", "Scenes, or `thesis`, or `all`");
  CLI::Option* mesh = add("Scene", "--mesh", a.mesh, "FILE", "A Wavefront OBJ file instead");
  mesh->excludes(scene);
  add("Scene", "--patches", a.patches, "KIND",
      "Faces of the mesh become linear, pn or phong patches")
      ->needs(mesh);
  add("Scene", "--frame", a.frame, "N", "Frame of the animation, from 0");
  add("Scene", "--turn", a.turn, "DEGREES", "Turns the picture about the view axis");
  add("Scene", "--resolution", a.resolution, "WxH", "Size of the frame in pixels");
  add("Tessellation", "--dice-area", a.dice_area, "PX",
      "Area of a quad in pixels; a triangle has half");
  add("Tessellation", "--grid", a.grid, "N", "A grid has at most N x N quads");
  add("Tessellation", "--drain", a.drain, "N", "Kernels drain after N micropolygons");
  add("Sampling", "--msaa", a.msaa, "N", "Samples a pixel: 1, 4, 9, 16 or 64");
  add("Sampling", "--jitter", a.jitter, "on|off", "Samples at random places of their cells");
  add("Sampling", "--seed", a.seed, "N", "Seed of the jitter");
  add("Kernels", "--edges", a.edges, "WHEN",
      "Edge equations in Test (inline) or in Bound (precomputed)");
  add("Kernels", "--stream-load-threshold", a.stream_load_threshold, "SHARE",
      "REPACK loads when this share of the lanes is free, 0 to 1");
  add("Kernels", "--cull", a.cull, "on|off", "Drop micropolygons that face away");
  add("Kernels", "--mode", a.mode, "MODE", "counting, checked or uncounted");
  add("Kernels", "--observe-every", a.observe_every, "N",
      "Memory and source lines are observed in one packet of N; 0 in none, 1 in all");
  add("Output", "--threads", a.threads, "N", "Threads; all of the host if left out");
}

std::vector<Configuration> resolve_scenes(const ExperimentArguments& arguments,
                                          DefaultScenes default_scenes) {
  Configuration shared;
  shared.turn_degrees = parse_number_of("turn_degrees", {"--turn", arguments.turn});
  resolve_tessellation(arguments, shared.tessellation);
  resolve_sampling(arguments, shared);
  resolve_kernel_options(arguments, shared);
  if (!arguments.mesh.empty()) {
    resolve_mesh(arguments, shared);
    return {shared};
  }
  std::vector<Configuration> configurations;
  for (const std::string& name : resolve_scene_names(arguments.scene, default_scenes)) {
    configurations.push_back(shared);
    configurations.back().scene = name;
    configurations.back().frame = resolve_frame(arguments.frame, find_scene(name));
  }
  return configurations;
}

int resolve_threads(const std::string& text) {
  if (!text.empty()) return parse_integer({"--threads", text}, 1, kMaxThreads);
  const int available = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(available, 1, kMaxThreads);
}

std::vector<std::string> resolve_kernels(const std::string& text) {
  std::vector<std::string> names;
  for (const Argument& element : parse_list({"--kernel", text}))
    names.push_back(parse_name(element, "a kernel", names_of(kernels())));
  return names;
}

std::vector<Micropolygon> resolve_shapes(const std::string& text) {
  std::vector<Micropolygon> shapes;
  for (const Argument& element : parse_list({"--micropolygon", text}))
    shapes.push_back(parse_choice(element, kShapes));
  return shapes;
}

std::vector<int> resolve_widths(const std::string& text, const std::string& kernel) {
  const std::span<const int> available = find_kernel(kernel).widths;
  std::vector<std::string> names;
  for (const int width : available) names.push_back(std::to_string(width));
  std::vector<int> widths;
  if (text.empty()) {
    for (const int width : kThesisWidths)
      if (std::find(available.begin(), available.end(), width) != available.end())
        widths.push_back(width);
    return widths.empty() ? std::vector<int>(available.begin(), available.end()) : widths;
  }
  for (const Argument& element : parse_list({"--width", text})) {
    const std::string name = parse_name(element, fmt::format("a width of {}", kernel), names);
    widths.push_back(std::stoi(name));
  }
  return widths;
}

std::vector<Configuration> cross(const std::vector<Configuration>& scenes,
                                 const std::vector<std::string>& kernels, const std::string& widths,
                                 const std::vector<Micropolygon>& shapes) {
  std::vector<Configuration> configurations;
  for (const Configuration& scene : scenes)
    for (const Micropolygon shape : shapes)
      for (const std::string& kernel : kernels)
        for (const int width : resolve_widths(widths, kernel)) {
          Configuration& c = configurations.emplace_back(scene);
          c.options.shape = shape;
          c.kernel = kernel;
          c.width = width;
        }
  return configurations;
}

}  // namespace lanescope
