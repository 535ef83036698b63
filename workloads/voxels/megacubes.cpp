// SPDX-License-Identifier: MIT
#include "workloads/voxels/megacubes.h"

#include <algorithm>
#include <cmath>

namespace lanescope {
namespace {

constexpr int kBefore = kMegaCube - 1;
constexpr int kMegaVolume = kMegaCube * kMegaCube * kMegaCube;

/// Adds to each element those of the next three along an axis.
void add_next(std::vector<std::uint8_t>& values, std::size_t stride, std::size_t length) {
  const std::size_t block = stride * length;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t left = length - 1 - i % block / stride;
    for (std::size_t next = 1; next <= std::min<std::size_t>(kBefore, left); ++next)
      values[i] = static_cast<std::uint8_t>(values[i] + values[i + next * stride]);
  }
}

}  // namespace

Megacubes::Megacubes(const World& world, float least_share)
    : size_{world.size().x + kBefore, world.size().y + kBefore, world.size().z + kBefore},
      least_(std::max(1, static_cast<int>(std::ceil(least_share * kMegaVolume)))) {
  const auto x = static_cast<std::size_t>(size_.x), y = static_cast<std::size_t>(size_.y);
  filled_.resize(x * y * static_cast<std::size_t>(size_.z));
  const Cube size = world.size();
  for (int k = 0; k < size.z; ++k)
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) filled_[index({i, j, k})] = world.filled({i, j, k});
  add_next(filled_, 1, x);
  add_next(filled_, x, y);
  add_next(filled_, x * y, static_cast<std::size_t>(size_.z));
}

bool Megacubes::opaque(Cube c) const {
  const auto is_in = [](int place, int size) {
    return place >= -kBefore && place < size - kBefore;
  };
  return is_in(c.x, size_.x) && is_in(c.y, size_.y) && is_in(c.z, size_.z) &&
         filled_[index(c)] >= least_;
}

std::size_t Megacubes::index(Cube c) const {
  return (static_cast<std::size_t>(c.z + kBefore) * static_cast<std::size_t>(size_.y) +
          static_cast<std::size_t>(c.y + kBefore)) *
             static_cast<std::size_t>(size_.x) +
         static_cast<std::size_t>(c.x + kBefore);
}

}  // namespace lanescope
