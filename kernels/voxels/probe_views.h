// SPDX-License-Identifier: MIT
// Pictures of a world that `render --show` draws: in other light, and as the probes see it.
#pragma once

#include <array>

#include "kernels/kernel.h"

namespace lanescope {

extern const std::array<View, 5> kProbeViews;

}  // namespace lanescope
