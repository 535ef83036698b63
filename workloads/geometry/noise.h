// SPDX-License-Identifier: MIT
// Gradient noise from integer hashes: smooth, deterministic, the same with every compiler.
#pragma once

#include <cstdint>

#include "workloads/geometry/vector.h"

namespace lanescope {

namespace detail {

// The eight corners of a lattice cell side by side; corner i is x + (i & 1), y + (i >> 1 & 1),
// z + (i >> 2). Noise is most of the time of a tessellation, hence vectors.
using Corners [[gnu::vector_size(32)]] = float;
using CornerBits [[gnu::vector_size(32)]] = std::uint32_t;
using CornerInts [[gnu::vector_size(32)]] = std::int32_t;

inline constexpr std::uint32_t kHashX = 0x8da6b343u, kHashY = 0xd8163841u, kHashZ = 0xcb1ab31fu;

inline CornerBits corner_hashes(std::int32_t x, std::int32_t y, std::int32_t z) {
  constexpr CornerBits kStepX = {0, kHashX, 0, kHashX, 0, kHashX, 0, kHashX};
  constexpr CornerBits kStepY = {0, 0, kHashY, kHashY, 0, 0, kHashY, kHashY};
  constexpr CornerBits kStepZ = {0, 0, 0, 0, kHashZ, kHashZ, kHashZ, kHashZ};
  CornerBits h = (static_cast<std::uint32_t>(x) * kHashX + kStepX) ^
                 (static_cast<std::uint32_t>(y) * kHashY + kStepY) ^
                 (static_cast<std::uint32_t>(z) * kHashZ + kStepZ);
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

/// One component of the corners' gradients, from ten bits of the hash: -511 to 512.
inline Corners gradient_component(CornerBits hashes, int shift) {
  return __builtin_convertvector(CornerInts((hashes >> shift) & 1023u) - 511, Corners);
}

constexpr float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

}  // namespace detail

/// Noise with features about 1 apart, zero mean, roughly within [-1, 1]. Requires coordinates
/// within the range of a 32-bit integer.
inline float noise(Vec3 p) {
  using detail::Corners;
  const Vec3 base{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 f = p - base;
  const detail::CornerBits hashes =
      detail::corner_hashes(static_cast<std::int32_t>(base.x), static_cast<std::int32_t>(base.y),
                            static_cast<std::int32_t>(base.z));
  constexpr Corners kX = {0, 1, 0, 1, 0, 1, 0, 1};
  constexpr Corners kY = {0, 0, 1, 1, 0, 0, 1, 1};
  constexpr Corners kZ = {0, 0, 0, 0, 1, 1, 1, 1};
  const Corners c = detail::gradient_component(hashes, 0) * (f.x - kX) +
                    detail::gradient_component(hashes, 10) * (f.y - kY) +
                    detail::gradient_component(hashes, 20) * (f.z - kZ);
  const float wx = detail::fade(f.x), wy = detail::fade(f.y), wz = detail::fade(f.z);
  const float near = mix(mix(c[0], c[1], wx), mix(c[2], c[3], wx), wy);
  const float far = mix(mix(c[4], c[5], wx), mix(c[6], c[7], wx), wy);
  return mix(near, far, wz) * (1.0f / 420.0f);
}

/// A sum of `octaves` noises, each of twice the frequency and `gain` times the height of the one
/// before.
inline float fractal_noise(Vec3 p, int octaves, float gain = 0.5f) {
  float sum = 0.0f;
  float height = 1.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += height * noise(p);
    p = p * 2.0f + Vec3{17.3f, 5.1f, 11.7f};
    height *= gain;
  }
  return sum;
}

}  // namespace lanescope
