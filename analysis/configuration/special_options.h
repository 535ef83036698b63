// SPDX-License-Identifier: MIT
// What is particular to a configuration, in the words of the command line.
#pragma once

#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// An option and its value: `resolution`, `480x300`.
struct SpecialOption {
  std::string parameter;  ///< The first of those that the option sets: `width_px`.
  std::string option;     ///< Without its dashes.
  std::string value;
  bool of_source;  ///< Of the kind of work, not of the kernel.
  bool by_scene;   ///< The default is the scene's.

  /// `resolution = 480x300`
  std::string text() const { return option + " = " + value; }
};

/// The options of the kind of work and of the kernel that are not as they are by default, and those
/// whose default the scene decides. Every argument, by its name, if the program does not have the
/// kernel.
std::vector<SpecialOption> special_options(const Configuration& configuration);

/// A scene, with what it decides: `teapot, frame = 4`.
std::string scene_title(const Configuration& configuration);

}  // namespace lanescope
