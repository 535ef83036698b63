// SPDX-License-Identifier: MIT
#include "workloads/voxels/brick.h"

#include "simulator/base/random.h"

namespace lanescope {

std::uint64_t Brick::hash() const {
  std::uint64_t hash = mix64(first_probe);
  for (const int place : {origin.x, origin.y, origin.z})
    hash = mix64(hash ^ static_cast<std::uint64_t>(place));
  for (std::size_t i = 0; i < rows.size(); i += kRowWords)
    hash = mix64(hash ^ (std::uint64_t{rows[i]} | std::uint64_t{rows[i + 1]} << 32));
  for (const Probe& probe : probes)
    hash = mix64(hash ^ static_cast<std::uint64_t>(probe.x << 16 | probe.y << 8 | probe.z));
  return hash;
}

void Brick::fill(Cube c) {
  const auto word = static_cast<std::size_t>(row(c.y, c.z));
  if (c.x >= 16) rows[word + kForward] |= 1u << (c.x - 16);
  if (c.x < 32) rows[word + kBackward] |= 1u << (31 - c.x);
}

void Brick::fill_mega(Cube c) {
  const int place = c.x & (kMegaCube - 1), step = (c.x - place) / kMegaCube;
  const auto word = static_cast<std::size_t>(mega_row(place, c.y, c.z));
  if (step >= 0) rows[word + kForward] |= 1u << step;
  if (step <= 2) rows[word + kBackward] |= 1u << (2 - step);
}

}  // namespace lanescope
