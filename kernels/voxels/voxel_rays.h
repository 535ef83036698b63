// SPDX-License-Identifier: MIT
// The reference: a ray for each sample walks the grid, and harmonics are sums of doubles.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "kernels/kernel.h"
#include "kernels/voxels/sky_samples.h"
#include "workloads/voxels/brick.h"

namespace lanescope {

/// Whether a ray from a corner of a brick meets a filled cube within kReach cubes of the corner
/// along each axis or, beyond them, an opaque megacube. `octant` says which way each axis goes.
bool is_occluded(const Brick& brick, const Probe& probe, int octant,
                 const SampleDirection& direction);

/// Whether a ray from a corner meets a filled cube of the world, however far.
bool is_occluded_by(const World& world, Cube corner, int octant, const SampleDirection& direction);

/// Takes the image of an octant; null if the octant is blocked.
using TakeImage = std::function<void(int octant, const std::int32_t* words)>;

/// The sky that a probe sees by these samples, an octant after the other.
std::array<double, kHarmonics> sky_seen(const Brick& brick, const Probe& probe,
                                        const SkySamples& samples, const TakeImage& take);

}  // namespace lanescope
