// SPDX-License-Identifier: MIT
// The options that commands share: every parameter of every kernel and kind of work of the program,
// as they are declared, parsed strictly, and resolved into configurations.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/cli/options.h"
#include "analysis/cli/parameter_axis.h"
#include "analysis/configuration/configuration.h"

namespace lanescope {

/// The names of parameters of every run.
inline constexpr std::string_view kKernel = "kernel";
inline constexpr std::string_view kWidth = "width_lanes";
inline constexpr std::string_view kScene = "scene";

/// Names a scene that is a file.
inline constexpr const char* kFileOption = "--mesh";

/// What the options hold, and what a command runs where they hold nothing.
struct ExperimentArguments {
  /// Whether the usual kernels run at all their usual widths, or one of them at its first.
  bool several = true;
  /// Whether that one is the last of them, or the first.
  bool takes_last_kernel = false;
  /// Whether other parameters can have several values, so that the help says how they are given.
  bool takes_lists = true;
  /// Values that the command has by default, by name; of others the parameter says the default.
  /// Scenes may be `all`.
  std::map<std::string, std::vector<Value>, std::less<>> defaults;
  /// Names of parameters that are no options, as the command decides them itself.
  std::vector<std::string_view> left_out;

  std::map<std::string, std::string, std::less<>> texts;  ///< By option; empty if not given.
  std::string file;  ///< A scene that is a file, of which the name may have commas.
};

/// Declares the options. `arguments` must outlive `options`.
void add_experiment_options(CommandOptions& options, ExperimentArguments& arguments);

/// Declares `--threads`, which values.h reads.
void add_threads_option(CommandOptions& options, std::string& text);

/// Every combination of the values that were asked for, each once, with every parameter resolved.
/// In this order, the last varying fastest: scene, parameters of the kind of work, mode and
/// observation, kernel, its parameters, width. Throws InputError, naming the option, for what is
/// out of range, for kernels of several kinds of work, and for options that no kernel takes or that
/// apply to no scene.
std::vector<Configuration> resolve_configurations(const ExperimentArguments& arguments);

/// The kernels of a kind of work that a command runs if it has no kernels of its own and none is
/// named.
std::vector<const Kernel*> default_kernels(const ExperimentArguments& arguments,
                                           const Workload& workload);

/// The scenes that a word stands for: `all`, or the group of a study of this kind of work; none if
/// it stands for none.
std::vector<std::string> scenes_of_word(std::string_view word, const Workload& workload);

}  // namespace lanescope
