// SPDX-License-Identifier: MIT
// One configuration of an experiment, with every parameter resolved: what identifies a run. Nothing
// here knows a parameter of a kind of work or of a kernel; they are found by name.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/kernel.h"

namespace lanescope {

inline constexpr int kMostWidth = 64;

/// The modes that a user can ask for.
inline constexpr std::array<Choice<Mode>, 3> kModes{
    {{"counting", Mode::kCounting}, {"checked", Mode::kChecked}, {"uncounted", Mode::kUncounted}}};

/// A kernel at one width on one scene: all that decides what a run counts.
struct Configuration {
  std::string kernel;
  int width = 16;
  /// The name of a built-in scene, or the path of a file.
  std::string scene;
  Mode mode = Mode::kCounting;
  /// Memory and source lines are observed in every so many pieces of work; 0 in none, 1 in all.
  int observe_every = 16;
  /// Of the kind of work, then of the kernel: every parameter that they take.
  Arguments arguments;

  bool operator==(const Configuration&) const = default;
};

/// The parameters that every kernel has: those of the members of Configuration.
const Parameters<Configuration>& run_parameters();

/// The parameters of runs of a kernel, in the order of the JSON form: those of every run, of its
/// kind of work, of the kernel.
std::vector<Parameter> parameters_of(const Kernel& kernel);

/// The parameters of all kernels of the program, each once, in the order of their first kernels.
const std::vector<Parameter>& all_parameters();

/// The parameter of that name among those of all kernels, or null.
const Parameter* find_parameter(std::string_view name);

/// Whether runs of a kernel have the parameter of that name.
bool takes(const Kernel& kernel, std::string_view parameter);

/// The names of the kernels that take a parameter; `every kernel` if all do.
std::string takers_of(std::string_view parameter);

/// Why a file of that name can be no scene, for a message: it could not stand in a report. Empty if
/// it can.
std::string scene_name_problem(std::string_view scene);

/// The value of a parameter; nothing if the configuration does not have it.
Value value_of(const Configuration& configuration, std::string_view parameter);

/// Sets a parameter. Requires a value that it allows, and a parameter of run_parameters or of
/// `arguments`; others are added at the end of `arguments`.
void set_value(Configuration& configuration, std::string_view parameter, Value value);

/// All parameters of a configuration with their values, in order.
Arguments all_values(const Configuration& configuration);

/// A configuration in which every parameter has a value: `given` ones, else the defaults of the
/// kernel and its kind of work, else what the scene decides; those that the kernel does not take
/// are left out. If none is given, the kernel is the first that issues instructions, and the scene
/// the first of its kind of work.
/// Throws InputError for a kernel or a scene that there is not, and ParameterError for values that
/// are not allowed, alone or together.
Configuration resolved(const Arguments& given);

/// The kind of work of a configuration. Requires that the program has its kernel.
const Workload& workload_of(const Configuration& configuration);

/// Who hears how a scene is opened; both may be empty.
struct OpeningListener {
  /// Called with the finished share, from 0 to 1.
  OpeningProgress progress;
  /// Called with each of the notes of the source (Source::notes).
  std::function<void(const std::string&)> note;
};

/// Opens the scene of a configuration. Throws InputError as Workload::open does.
std::unique_ptr<Source> open_source(const Configuration& configuration,
                                    const OpeningListener& listener = {});

/// Whether the pieces of work of two configurations are the same, so that one source feeds both.
bool same_source(const Configuration& a, const Configuration& b);

/// The value of the facet of its kind of work (Workload::facet) as text, empty if it has none or
/// the program does not know the kernel.
std::string facet_of(const Configuration& configuration);

}  // namespace lanescope
