// SPDX-License-Identifier: MIT
// Worlds of cubes that are filled at random, each for itself.
#pragma once

#include "workloads/voxels/brick.h"
#include "workloads/voxels/scenes/parts.h"

namespace lanescope {

/// A world in which that many of a hundred cubes are filled. Those of a smaller share are filled
/// with a larger one, too. All places are alike, so probes are in the middle ones alone; the world
/// is large enough that they see nothing of its outside.
inline World scattered_world(int asked_cubes, std::uint64_t seed, int percent) {
  constexpr int kMiddle = 8;
  const int size_cubes = std::max(asked_cubes, kMiddle + 2 * kReach);
  enum Use { kFilled, kTint };
  WorldBuilder builder({size_cubes, size_cubes, size_cubes}, seed);
  const CubeMaterial warm[] = {builder.material({206, 92, 72}), builder.material({224, 152, 72}),
                               builder.material({228, 204, 128})};
  const CubeMaterial cold[] = {builder.material({58, 92, 140}), builder.material({84, 140, 160}),
                               builder.material({176, 200, 196})};
  const NoiseField warmth = builder.field(12.0f, kTint);
  WorldBuilder::for_box({0, 0, 0}, {size_cubes - 1, size_cubes - 1, size_cubes - 1}, [&](Cube c) {
    if (builder.random(c, kFilled) % 100 >= static_cast<std::uint64_t>(percent)) return;
    const auto& tints = warmth.at(middle_of(c)) > 0.0f ? warm : cold;
    builder.fill(c, tints[builder.random(c, kTint) % 3]);
  });
  World world = builder.take();
  world.margin = (size_cubes - kMiddle) / 2;
  return world;
}

}  // namespace lanescope
