// SPDX-License-Identifier: MIT
#include "analysis/configuration/configuration.h"

#include <tuple>

namespace lanescope {

SampleGrid Configuration::sample_grid() const {
  return {tessellation.width_px, tessellation.height_px, samples_per_pixel, jitter, seed};
}

TessellationOptions Configuration::tessellation_options() const {
  TessellationOptions complete = tessellation;
  complete.shape = options.shape;
  complete.samples_per_axis = sample_grid().samples_per_axis();
  return complete;
}

bool same_tessellation(const Configuration& a, const Configuration& b) {
  const auto key = [](const Configuration& c) {
    const TessellationOptions& t = c.tessellation;
    return std::tie(c.scene, c.mesh_patches, c.frame, c.turn_degrees, t.width_px, t.height_px,
                    c.samples_per_pixel, c.options.shape, t.dice_area_px, t.grid_limit,
                    t.packet_capacity, t.grid_overlap_px);
  };
  return key(a) == key(b);
}

std::string list_or(std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace lanescope
