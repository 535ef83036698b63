// SPDX-License-Identifier: MIT
// Random numbers that are the same with every compiler and library: stateless hashes.
#pragma once

#include <cstdint>

namespace lanescope {

/// A 64-bit mixing function (the finalizer of SplitMix64): every input bit reaches every output
/// bit.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Uniform in [0, 1) with 24 bits, from a hash.
constexpr float unit_float(std::uint64_t hash) { return static_cast<float>(hash >> 40) * 0x1p-24f; }

}  // namespace lanescope
