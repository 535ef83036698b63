// SPDX-License-Identifier: MIT
// Vectors of three floats, and functions that give the same bits with every compiler and library.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanescope {

/// A point, a direction or a linear colour. World coordinates are right-handed with y up.
struct Vec3 {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(float s, Vec3 a) { return a * s; }
constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

constexpr float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vec3 a) { return std::sqrt(dot(a, a)); }
/// Unit vector along `a`; not finite if `a` is zero.
inline Vec3 normalized(Vec3 a) { return a * (1.0f / length(a)); }
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

constexpr float mix(float a, float b, float t) { return a + (b - a) * t; }
constexpr Vec3 mix(Vec3 a, Vec3 b, float t) { return a + (b - a) * t; }
constexpr float saturate(float x) { return std::min(std::max(x, 0.0f), 1.0f); }
/// 0 below `low`, 1 above `high`, smooth between.
constexpr float smooth_step(float low, float high, float x) {
  const float t = saturate((x - low) / (high - low));
  return t * t * (3.0f - 2.0f * t);
}
/// A smooth hill: 1 at 0, 0 at and beyond distance 1; takes the squared distance.
constexpr float hill(float distance_squared) {
  const float t = std::max(0.0f, 1.0f - distance_squared);
  return t * t * t;
}

/// Sine of an angle in turns (1 is a full circle), to about 1e-6. The library's sine differs
/// between systems; this one is made of additions and products only.
inline float sin_turns(float turns) {
  float t = turns - std::floor(turns + 0.5f);
  t = std::min(t, 0.5f - t);
  t = std::max(t, -0.5f - t);
  const float x = t * (2.0f * std::numbers::pi_v<float>);
  const float s = x * x;
  const float series =
      1.0f +
      s * (-1.0f / 6 + s * (1.0f / 120 + s * (-1.0f / 5040 + s * (1.0f / 362880 - s / 39916800))));
  return x * series;
}
inline float cos_turns(float turns) { return sin_turns(turns + 0.25f); }

/// `p` turned about an axis through the origin, by an angle in turns, counterclockwise as seen
/// against the axis.
inline Vec3 turned_x(Vec3 p, float turns) {
  const float c = cos_turns(turns), s = sin_turns(turns);
  return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}
inline Vec3 turned_y(Vec3 p, float turns) {
  const float c = cos_turns(turns), s = sin_turns(turns);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}
inline Vec3 turned_z(Vec3 p, float turns) {
  const float c = cos_turns(turns), s = sin_turns(turns);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

}  // namespace lanescope
