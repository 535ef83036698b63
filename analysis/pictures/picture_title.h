// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// What a picture shows, for its title: the scene, the facet of its kind of work, and the options
/// of that kind that are not as by default: `teapot, shape = round, resolution = 480x300`.
std::string picture_title(const Configuration& configuration);

/// The file, within a directory of pictures, that shows the scene of a configuration:
/// `frame-teapot.png`. Of a file, its name without folder and ending.
std::string picture_name(const Configuration& configuration);

/// The command that draws the picture of a configuration's scene into a file.
std::string picture_command(const Configuration& configuration, const std::string& path);

}  // namespace lanescope
