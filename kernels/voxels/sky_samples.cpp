// SPDX-License-Identifier: MIT
#include "kernels/voxels/sky_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "workloads/geometry/vector.h"

namespace lanescope {
namespace {

constexpr int kFacePixels = 16;
constexpr int kDirectionGrid = 8;  ///< 8 x 8 directions for each harmonic.

/// Integrals of the harmonics are kept in units of 2^-28: the largest, sqrt(4 pi) over the whole
/// sphere, fits 31 bits.
constexpr double kUnit = 0x1p-28;

const double kConstant = std::sqrt(1.0 / (4.0 * std::numbers::pi));
const double kLinear = std::sqrt(3.0 / (4.0 * std::numbers::pi));

/// The integrals of 1, x, y and z over the solid angle of a square on the face x = 1: Gauss's rule
/// of three points either way, which has an error below 1e-10 for the pixels of a face.
std::array<double, kHarmonics> pixel_moments(double u, double v, double size) {
  const double reach = std::sqrt(0.6) * size / 2;
  const double places[] = {-reach, 0.0, reach};
  const double weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  std::array<double, kHarmonics> moments{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double y = u + places[i], z = v + places[j];
      const double squared = 1.0 + y * y + z * z;
      const double length = std::sqrt(squared);
      const double solid_angle = weights[i] * weights[j] * size * size / (squared * length);
      const double direction[] = {1.0, 1.0 / length, y / length, z / length};
      for (std::size_t h = 0; h < kHarmonics; ++h) moments[h] += solid_angle * direction[h];
    }
  return moments;
}

SkySamples face_samples() {
  SkySamples samples;
  samples.words = kMostWords;
  samples.scale.fill(kUnit);
  constexpr double kSize = 1.0 / kFacePixels;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int v = 0; v < kFacePixels; ++v)
      for (int u = 0; u < kFacePixels; ++u) {
        SampleDirection direction;
        direction[axis] = 2 * kFacePixels;
        direction[(axis + 1) % 3] = 2 * u + 1;
        direction[(axis + 2) % 3] = 2 * v + 1;
        samples.directions.push_back(direction);
        const auto moments = pixel_moments((u + 0.5) * kSize, (v + 0.5) * kSize, kSize);
        samples.worth[0].push_back(
            static_cast<std::int32_t>(std::llround(moments[0] * kConstant / kUnit)));
        for (std::size_t i = 0; i < 3; ++i)
          samples.worth[1 + (axis + i) % 3].push_back(
              static_cast<std::int32_t>(std::llround(moments[1 + i] * kLinear / kUnit)));
      }
  return samples;
}

/// Rounded to integers that do not vanish; 2^15 is long enough for errors below 1e-4.
SampleDirection rounded(float x, float y, float z, std::size_t axis) {
  const auto component = [](float value) {
    return std::max(1, static_cast<std::int32_t>(std::floor(value * 32768.0f + 0.5f)));
  };
  SampleDirection direction;
  direction[axis] = component(x);
  direction[(axis + 1) % 3] = component(y);
  direction[(axis + 2) % 3] = component(z);
  return direction;
}

/// A direction with this cosine to an axis, turned about it by a share of the octant's quarter.
SampleDirection around(std::size_t axis, float cosine, float share) {
  const float sine = std::sqrt(1.0f - cosine * cosine);
  const float turns = share / 4;
  return rounded(cosine, sine * cos_turns(turns), sine * sin_turns(turns), axis);
}

/// Cube (i, j) of a grid over the first octant, in which cells are equal shares of the integral of
/// 1 (harmonic 0) or of the cosine to an axis.
SampleDirection spread_direction(int harmonic, int i, int j) {
  const float s = (static_cast<float>(i) + 0.5f) / kDirectionGrid;
  const float share = (static_cast<float>(j) + 0.5f) / kDirectionGrid;
  return harmonic == 0 ? around(1, s, share)
                       : around(static_cast<std::size_t>(harmonic - 1), std::sqrt(s), share);
}

SkySamples counted_samples() {
  SkySamples samples;
  samples.words = kHarmonics * kCountedWords;
  samples.by_counting = true;
  constexpr int kPerHarmonic = kDirectionGrid * kDirectionGrid;
  static_assert(kPerHarmonic == kCountedWords * kWordBits);
  // The first octant's integrals of the harmonics: an eighth of the sphere, and pi / 4 of a cosine.
  const double whole = kConstant * std::numbers::pi / 2, cosine = kLinear * std::numbers::pi / 4;
  for (int h = 0; h < kHarmonics; ++h) {
    samples.scale[static_cast<std::size_t>(h)] = (h == 0 ? whole : cosine) / kPerHarmonic;
    for (int i = 0; i < kDirectionGrid; ++i)
      for (int j = 0; j < kDirectionGrid; ++j) {
        samples.directions.push_back(spread_direction(h, i, j));
        for (int other = 0; other < kHarmonics; ++other)
          samples.worth[static_cast<std::size_t>(other)].push_back(other == h);
      }
  }
  return samples;
}

}  // namespace

const SkySamples& sky_samples(SkyProjection projection) {
  static const SkySamples faces = face_samples();
  static const SkySamples directions = counted_samples();
  return projection == SkyProjection::kFaces ? faces : directions;
}

const std::vector<SampleDirection>& even_directions() {
  static const std::vector<SampleDirection> directions = [] {
    constexpr int kHigh = 32, kAround = kEvenDirections / kHigh;
    std::vector<SampleDirection> all;
    for (int i = 0; i < kHigh; ++i)
      for (int j = 0; j < kAround; ++j)
        all.push_back(around(1, (static_cast<float>(i) + 0.5f) / kHigh,
                             (static_cast<float>(j) + 0.5f) / kAround));
    return all;
  }();
  return directions;
}

}  // namespace lanescope
