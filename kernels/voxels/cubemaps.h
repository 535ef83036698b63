// SPDX-License-Identifier: MIT
// Cubemaps of one bit a pixel, of some probes of a world, to be looked at.
#pragma once

#include "kernels/kernel.h"

namespace lanescope {

std::unique_ptr<Output> open_cubemaps(const Arguments& arguments, const Source& source);
std::uint64_t cubemaps_bytes(const Arguments& arguments);
std::unique_ptr<Execution> start_cubemaps(const Launch& launch);

}  // namespace lanescope
