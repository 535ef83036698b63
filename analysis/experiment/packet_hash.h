// SPDX-License-Identifier: MIT
// A fingerprint of geometry: equal packets in any order give equal sums.
#pragma once

#include <cstdint>

#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {

/// A hash of every value of a packet and of its place in the scene. A scene's hash is the sum over
/// its packets, modulo 2^64.
std::uint64_t packet_hash(const Packet& packet);

}  // namespace lanescope
