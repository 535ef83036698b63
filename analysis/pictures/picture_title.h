// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// What a picture shows, for its title: `teapot, frame 4, triangles`.
inline std::string picture_title(const Configuration& c) {
  const std::string frame = c.is_mesh() ? "" : ", frame " + std::to_string(c.frame);
  return c.scene + frame + ", " + std::string(to_string(c.shape())) + "s";
}

}  // namespace lanescope
