// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/frame.h"

#include <algorithm>

#include "simulator/base/random.h"

namespace lanescope {

std::uint64_t Frame::hash() const {
  std::uint64_t hash = 0;
  for (const std::uint64_t sample : samples_) hash = mix64(hash ^ sample);
  return hash;
}

std::uint64_t Frame::covered() const {
  return static_cast<std::uint64_t>(samples_.size()) -
         static_cast<std::uint64_t>(std::count(samples_.begin(), samples_.end(), kEmpty));
}

}  // namespace lanescope
