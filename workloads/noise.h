// SPDX-License-Identifier: MIT
// Gradient noise from integer hashes: smooth, deterministic, the same with every compiler.
#pragma once

#include <cstdint>

#include "workloads/vector.h"

namespace lanescope {

namespace detail {

inline std::uint32_t lattice_hash(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343u ^
                    static_cast<std::uint32_t>(y) * 0xd8163841u ^
                    static_cast<std::uint32_t>(z) * 0xcb1ab31fu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

/// The gradient of a lattice point, three components of ten bits each, times the offset from it.
inline float lattice_gradient(std::int32_t x, std::int32_t y, std::int32_t z, Vec3 offset) {
  const std::uint32_t h = lattice_hash(x, y, z);
  const auto component = [h](int shift) {
    return static_cast<float>(static_cast<std::int32_t>(h >> shift & 1023u) - 511);
  };
  return component(0) * offset.x + component(10) * offset.y + component(20) * offset.z;
}

constexpr float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

}  // namespace detail

/// Noise with features about 1 apart, zero mean, roughly within [-1, 1].
inline float noise(Vec3 p) {
  using detail::lattice_gradient;
  const Vec3 base{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 f = p - base;
  const auto x = static_cast<std::int32_t>(base.x);
  const auto y = static_cast<std::int32_t>(base.y);
  const auto z = static_cast<std::int32_t>(base.z);
  const Vec3 w{detail::fade(f.x), detail::fade(f.y), detail::fade(f.z)};
  const auto edge = [&](int dy, int dz) {
    const Vec3 near{f.x, f.y - static_cast<float>(dy), f.z - static_cast<float>(dz)};
    const Vec3 far{f.x - 1.0f, near.y, near.z};
    return mix(lattice_gradient(x, y + dy, z + dz, near),
               lattice_gradient(x + 1, y + dy, z + dz, far), w.x);
  };
  const float low = mix(edge(0, 0), edge(1, 0), w.y);
  const float high = mix(edge(0, 1), edge(1, 1), w.y);
  return mix(low, high, w.z) * (1.0f / 420.0f);
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
