// SPDX-License-Identifier: MIT
// The samples of an octant: directions, the bits that they are in an image, and what each is worth
// to the harmonics.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/voxels/probe_field.h"
#include "workloads/voxels/options.h"

namespace lanescope {

/// The octants around a probe: bit 0 is set where x falls, bit 1 where y does, bit 2 where z does.
inline constexpr int kOctants = 8;
/// Bits of a word of an image.
inline constexpr int kWordBits = 32;
/// Words of the largest image: three faces of 16 x 16 bits.
inline constexpr int kMostWords = 24;

/// A direction of the first octant, in integers so that it can be followed exactly.
using SampleDirection = std::array<std::int32_t, 3>;

/// Whether harmonic h changes its sign between the first octant and this one.
constexpr bool is_negative(int harmonic, int octant) {
  return harmonic > 0 && (octant >> (harmonic - 1) & 1) != 0;
}

/// Sample s is bit s % 32 of word s / 32. What it is worth to a harmonic is an integer, so that
/// sums are exact, and the same in any order.
struct SkySamples {
  int words = 0;
  std::vector<SampleDirection> directions;  ///< [32 * words]
  /// [harmonic][32 * words] What a sample that sees the sky adds.
  std::array<std::vector<std::int32_t>, kHarmonics> worth;
  /// A harmonic over the sum of worths.
  std::array<double, kHarmonics> scale{};
  /// Each word's samples are worth 1 to one harmonic and nothing to the others: a harmonic is the
  /// number of samples that see the sky, over two words.
  bool by_counting = false;

  int count() const { return words * kWordBits; }
};

/// Words of an image that are worth something to one harmonic, if SkySamples::by_counting.
inline constexpr int kCountedWords = 2;

/// Faces: pixel (u, v) of 0 ... 15 each is bit 16 (v % 2) + u of word v / 2 of its face, which are
/// those towards x, y and z; u and v run along the two axes that follow. Directions are through the
/// centres of pixels, and a pixel is worth the integral of the harmonic over its solid angle.
///
/// Directions: two words for each harmonic, as dense as the harmonic is large.
const SkySamples& sky_samples(SkyProjection projection);

/// Directions of equal solid angle, in this number for an octant: what both are measured against.
inline constexpr int kEvenDirections = 512;
const std::vector<SampleDirection>& even_directions();

}  // namespace lanescope
