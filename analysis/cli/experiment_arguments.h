// SPDX-License-Identifier: MIT
// The options that commands share: which scenes, how they are tessellated and sampled, how kernels
// are started. Declared once, parsed strictly, resolved into configurations.
#pragma once

#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace CLI {
class App;
}

namespace lanescope {

/// The texts given for the shared options, or their defaults. An empty text means that the default
/// depends on other options.
struct ExperimentArguments {
  std::string scene;
  std::string mesh;
  std::string patches = "pn";
  std::string frame;
  std::string turn = "0";
  std::string resolution;
  std::string dice_area;
  std::string grid;
  std::string drain;
  std::string msaa;
  std::string jitter;
  std::string seed;
  std::string edges;
  std::string stream_load_threshold;
  std::string cull;
  std::string mode;
  std::string observe_every;
  std::string threads;

  /// Defaults are those of a Configuration.
  ExperimentArguments();
};

/// Which scenes a command shows if none is named.
enum class DefaultScenes { kThesis, kAll, kFirst };

/// Declares the options. `arguments` must outlive `app`.
void add_experiment_options(CLI::App& app, ExperimentArguments& arguments);

/// A configuration for each scene, with every parameter resolved except kernel, width and
/// micropolygon. Throws InputError, naming the option, for anything out of range.
std::vector<Configuration> resolve_scenes(const ExperimentArguments& arguments,
                                          DefaultScenes default_scenes);

/// Threads to use: as asked, or as many as the host has.
int resolve_threads(const std::string& text);
inline int resolve_threads(const ExperimentArguments& arguments) {
  return resolve_threads(arguments.threads);
}

/// Names of kernels from a list.
std::vector<std::string> resolve_kernels(const std::string& text);
/// Kinds of micropolygon from a list.
std::vector<Micropolygon> resolve_shapes(const std::string& text);
/// Widths of a kernel from a list. An empty text means 8, 16, 32 and 64, or all of the kernel's if
/// it has none of these.
std::vector<int> resolve_widths(const std::string& text, const std::string& kernel);

/// Every scene with every kernel at every width on every kind of micropolygon.
std::vector<Configuration> cross(const std::vector<Configuration>& scenes,
                                 const std::vector<std::string>& kernels, const std::string& widths,
                                 const std::vector<Micropolygon>& shapes);

}  // namespace lanescope
