// SPDX-License-Identifier: MIT
// Pictures of what kernels and their views write: colours as they are, counts as a heat map.
#pragma once

#include <string>

#include "kernels/output.h"

namespace lanescope {

/// The contents of a PNG file: pixel for pixel; counts with a colour bar, and `title` above them.
std::string raster_png(const Raster& raster, const std::string& title);

/// Counts, dark where they are 0, with a colour bar.
std::string heat_map_png(const Raster& raster, const std::string& title);

/// The value at which the scale of counts ends: few pixels are above it, and they do not darken the
/// others.
double scale_end(const Raster& raster);

}  // namespace lanescope
