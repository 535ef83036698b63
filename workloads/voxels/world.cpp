// SPDX-License-Identifier: MIT
#include "workloads/voxels/world.h"

#include <algorithm>

#include "simulator/base/error.h"

namespace lanescope {

World::World(Cube size) : size_(size) {
  const auto fits = [](int cubes) { return cubes >= 1 && cubes <= kMostCubes; };
  LANESCOPE_CHECK(fits(size.x) && fits(size.y) && fits(size.z), "a world of {} x {} x {} cubes",
                  size.x, size.y, size.z);
  const std::size_t volume = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                             static_cast<std::size_t>(size.z);
  LANESCOPE_CHECK(volume <= kMostVolume, "a world of {} cubes", volume);
  cubes_.resize(volume);
}

std::uint64_t World::filled_count() const {
  return cubes_.size() - static_cast<std::uint64_t>(std::count(cubes_.begin(), cubes_.end(), 0));
}

}  // namespace lanescope
