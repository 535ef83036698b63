// SPDX-License-Identifier: MIT
// The samples of an octant: where they are, and what they are worth in all.
#include "kernels/voxels/sky_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lanescope {
namespace {

/// The integral of a harmonic over the first octant.
double octant_integral(int harmonic) {
  return harmonic == 0 ? std::sqrt(std::numbers::pi) / 4 : std::sqrt(3 * std::numbers::pi) / 8;
}

class Samples : public testing::TestWithParam<SkyProjection> {};

TEST_P(Samples, AreWorthTheWholeOctant) {
  const SkySamples& samples = sky_samples(GetParam());
  for (int h = 0; h < kHarmonics; ++h) {
    const auto i = static_cast<std::size_t>(h);
    double sum = 0;
    for (const std::int32_t worth : samples.worth[i]) sum += worth;
    EXPECT_NEAR(sum * samples.scale[i], octant_integral(h), 1e-6) << "harmonic " << h;
  }
}

TEST_P(Samples, LieInTheOctant) {
  const SkySamples& samples = sky_samples(GetParam());
  ASSERT_EQ(samples.directions.size(), static_cast<std::size_t>(samples.count()));
  for (const SampleDirection& direction : samples.directions)
    for (const std::int32_t component : direction) {
      EXPECT_GT(component, 0);
      EXPECT_LE(component, 1 << 15);
    }
}

/// The sum of all worths of a probe that sees everything stays within 31 bits.
TEST_P(Samples, SumsFit) {
  for (const auto& worths : sky_samples(GetParam()).worth) {
    std::int64_t sum = 0;
    for (const std::int32_t worth : worths) sum += worth;
    EXPECT_LT(kOctants * sum, std::int64_t{1} << 31);
  }
}

INSTANTIATE_TEST_SUITE_P(Projections, Samples,
                         testing::Values(SkyProjection::kFaces, SkyProjection::kDirections),
                         [](const auto& info) {
                           return std::string(name_of(kProjections, info.param));
                         });

TEST(FaceSamples, AreThePixels) {
  const SkySamples& samples = sky_samples(SkyProjection::kFaces);
  ASSERT_EQ(samples.words, 24);
  // Face towards y (the second), pixel u = 3 along z, v = 5 along x.
  const std::size_t sample = 256 + 5 * 16 + 3;
  EXPECT_EQ(samples.directions[sample], (SampleDirection{11, 32, 7}));
  // Where x and y are larger, a pixel is worth more to their harmonics than to that of z.
  EXPECT_GT(samples.worth[2][sample], samples.worth[1][sample]);
  EXPECT_GT(samples.worth[1][sample], samples.worth[3][sample]);
}

/// As dense as the harmonic is large: of the directions for harmonic x, as many as the integral of
/// x says have an x above one half (three quarters), and any two axes are alike.
TEST(DirectionSamples, AreAsDenseAsTheHarmonicIsLarge) {
  const SkySamples& samples = sky_samples(SkyProjection::kDirections);
  ASSERT_EQ(samples.words, 8);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int above = 0;
    for (std::size_t s = 64 * (axis + 1); s < 64 * (axis + 2); ++s) {
      const SampleDirection& d = samples.directions[s];
      const double length =
          std::sqrt(double(d[0]) * d[0] + double(d[1]) * d[1] + double(d[2]) * d[2]);
      above += d[axis] > length / 2;
    }
    EXPECT_EQ(above, 48);
  }
}

}  // namespace
}  // namespace lanescope
