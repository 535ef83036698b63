// SPDX-License-Identifier: MIT
// Probes rendered without the machine, to measure against: as the article's loop does, and as
// across_cameras does, by hand.
#pragma once

#include "kernels/voxels/counters.h"
#include "kernels/voxels/cube_images.h"
#include "workloads/voxels/brick.h"

namespace lanescope::benchmarks {

/// Cubes as bytes, which the article's loop walks.
struct ByteBrick {
  explicit ByteBrick(const Brick& brick);
  const Brick* brick;
  std::vector<std::uint8_t> cubes;  ///< [z][y][x]
};

/// Images of all open octants, and harmonics, an octant after the other: a loop over 16 x 16 x 16
/// bytes, and an image that is merged for each that is not 0. Returns the hash of the images.
std::uint64_t article_loop(const ByteBrick& brick, SkyProjection projection,
                           std::vector<Harmonics>& harmonics);

/// Lanes of the host: 16 with AVX-512, else 8.
#ifdef __AVX512F__
inline constexpr int kHostLanes = 16;
#else
inline constexpr int kHostLanes = 8;
#endif

/// What across_cameras does at W lanes, in vectors of the host. Returns the hash of the images.
template <int W>
std::uint64_t cameras_by_hand(const Brick& brick, SkyProjection projection,
                              std::vector<Harmonics>& harmonics);

}  // namespace lanescope::benchmarks
