// SPDX-License-Identifier: MIT
// The parameters of a configuration in the words of the command line, and what is particular to it.
#pragma once

#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// An option and its value: `resolution`, `480x300`.
struct NamedOption {
  std::string parameter;  ///< The first of those that the option sets: `width_px`.
  std::string option;     ///< Without its dashes.
  std::string value;
  bool of_source;  ///< Of the kind of work, not of the kernel.
  bool by_scene;   ///< The default is the scene's.
  bool special;    ///< Not as it is by default, or decided by the scene.
  bool stated;     ///< Tables state it: it is special, or is to be stated always.

  /// `resolution = 480x300`
  std::string text() const { return option + " = " + value; }
};

/// The options of the kind of work and of the kernel, in their order. By the names of arguments,
/// all special, if the program does not have the kernel.
std::vector<NamedOption> named_options(const Configuration& configuration);

/// Those that are special.
std::vector<NamedOption> special_options(const Configuration& configuration);

/// What tables state of runs: `resolution = 1728x1080, msaa = 4, cull = on`, and what is special,
/// each option with all its values. Without the facet, which tables show side by side, and without
/// what several scenes decide, each in its own way.
std::string shown_setting(const std::vector<const Configuration*>& configurations);

/// A scene, with what it decides: `teapot, frame = 4`.
std::string scene_title(const Configuration& configuration);

}  // namespace lanescope
