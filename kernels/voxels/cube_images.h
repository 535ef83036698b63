// SPDX-License-Identifier: MIT
// The prerendered cubes: for each of the 16 x 16 x 16 cubes of an octant, the samples that it
// covers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/voxels/sky_samples.h"
#include "workloads/voxels/brick.h"

namespace lanescope {

/// Rows of cubes along x of an octant, and all its cubes.
inline constexpr int kOctantRows = kReach * kReach;
inline constexpr int kOctantCubes = kReach * kOctantRows;

/// Cubes are numbered by rows, in the order of octant_rows(): cube 16 row + i is the i-th of its
/// row, counted from the probe.
struct CubeImages {
  /// A word of an image that is not 0.
  struct Part {
    std::uint32_t word;
    std::uint32_t bits;
  };

  int words = 0;
  std::vector<std::uint32_t> images;  ///< [kOctantCubes * words]
  std::vector<Part> parts;            ///< Of all cubes, one after the other.
  /// [2 * kOctantCubes] Of each cube where its parts begin, and how many they are.
  std::vector<std::uint32_t> parts_of_cube;

  std::span<const Part> parts_of(int cube) const {
    const auto at = 2 * static_cast<std::size_t>(cube);
    return std::span(parts).subspan(parts_of_cube[at], parts_of_cube[at + 1]);
  }
};

/// A sample is covered if its ray from the probe runs inside the cube for some length.
const CubeImages& cube_images(SkyProjection projection);

/// A row of an octant: y and z in cubes from the probe.
struct OctantRow {
  int y, z;
};
/// The rows of an octant, the nearest first, so that an image is full early.
const std::vector<OctantRow>& octant_rows();

}  // namespace lanescope
