// SPDX-License-Identifier: MIT
// Packets of a scene that benchmarks of rasterizers run on.
#pragma once

#include <vector>

#include "workloads/micropolygons/micropolygon.h"

namespace lanescope::benchmarks {

/// Size of the frame that the packets are for.
inline constexpr int kWidthPx = 480, kHeightPx = 300;

/// The packets of a scene, kept: tessellation is not what is measured.
std::vector<Packet> make_packets(Micropolygon shape);

}  // namespace lanescope::benchmarks
