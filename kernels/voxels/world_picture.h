// SPDX-License-Identifier: MIT
// Pictures of a world: a ray for each pixel walks the grid to the first filled cube, and harmonics
// are interpolated between the corners of the face that it meets.
#pragma once

#include "kernels/voxels/probe_field.h"

namespace lanescope {

/// What of a world a picture shows: the five of the article.
enum class Shown {
  kCubes,      ///< The field of cubes, in their colours, shaded by the direction of the face alone.
  kOcclusion,  ///< How much of the sky a point sees, whatever its normal: harmonic 0.
  kAmbient,    ///< The sky's light: occlusion, convolved with the normal and with the sky.
  kLighting,   ///< The sky's light and the sun's, with its shadows, on white.
  kFinal,      ///< The same on the colours of the cubes, with haze and a sky.
};

/// Draws the world from above one of its corners. `field` has the harmonics of its probes.
Raster draw_world(const World& world, const ProbeField& field, Shown shown);

}  // namespace lanescope
