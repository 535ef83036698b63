// SPDX-License-Identifier: MIT
#include "benchmarks/probe_renderers.h"

namespace lanescope::benchmarks {
namespace {

using Bits [[gnu::vector_size(32)]] = std::int32_t;  ///< A face: 256 bits.
using Four [[gnu::vector_size(16)]] = std::int32_t;

/// Images of cubes numbered x + 16 y + 256 z, as the article has them.
std::vector<std::uint32_t> images_in_order(const CubeImages& cubes) {
  std::vector<std::uint32_t> images(cubes.images.size());
  const auto words = static_cast<std::size_t>(cubes.words);
  for (std::size_t row = 0; row < octant_rows().size(); ++row) {
    const OctantRow at = octant_rows()[row];
    std::copy_n(
        cubes.images.begin() + static_cast<std::ptrdiff_t>(kReach * row * words), kReach * words,
        images.begin() + static_cast<std::ptrdiff_t>(
                             static_cast<std::size_t>(kReach * (at.y + 16 * at.z)) * words));
  }
  return images;
}

const std::vector<std::uint32_t>& images_of(SkyProjection projection) {
  static const auto faces = images_in_order(cube_images(SkyProjection::kFaces));
  static const auto directions = images_in_order(cube_images(SkyProjection::kDirections));
  return projection == SkyProjection::kFaces ? faces : directions;
}

/// Merges an octant into as many registers as its image needs.
template <int kRegisters>
void merge_octant(const ByteBrick& brick, const Probe& probe, int octant,
                  const std::uint32_t* images, std::uint32_t* image) {
  Bits bits[kRegisters] = {};
  const auto place = [&](int corner, int axis, int away) {
    return kReach + corner + (octant >> axis & 1 ? -1 - away : away);
  };
  for (int z = 0; z < kReach; ++z)
    for (int y = 0; y < kReach; ++y) {
      const int row = (place(probe.z, 2, z) * kBrickCubes + place(probe.y, 1, y)) * kBrickCubes;
      for (int x = 0; x < kReach; ++x) {
        if (brick.cubes[static_cast<std::size_t>(row + place(probe.x, 0, x))] == 0) continue;
        const std::uint32_t* const cube = images + 8 * kRegisters * (x + 16 * y + 256 * z);
        for (int r = 0; r < kRegisters; ++r) {
          Bits next;
          __builtin_memcpy(&next, cube + 8 * r, sizeof next);
          bits[r] |= next;
        }
      }
    }
  __builtin_memcpy(image, bits, sizeof bits);
}

/// The basis is selected by each bit and added up, four harmonics at a time.
Four add_up(const SkySamples& samples, const std::vector<Four>& basis, const std::uint32_t* image) {
  Four sum = {};
  for (int s = 0; s < samples.count(); ++s)
    sum += basis[static_cast<std::size_t>(s)] & ((image[s / kWordBits] >> s % kWordBits & 1) - 1);
  return sum;
}

std::vector<Four> basis_of(const SkySamples& samples) {
  std::vector<Four> basis;
  for (std::size_t s = 0; s < samples.directions.size(); ++s)
    basis.push_back(
        Four{samples.worth[0][s], samples.worth[1][s], samples.worth[2][s], samples.worth[3][s]});
  return basis;
}

}  // namespace

ByteBrick::ByteBrick(const Brick& b) : brick(&b) {
  for (int z = 0; z < kBrickCubes; ++z)
    for (int y = 0; y < kBrickCubes; ++y)
      for (int x = 0; x < kBrickCubes; ++x) cubes.push_back(b.filled({x, y, z}));
}

std::uint64_t article_loop(const ByteBrick& bytes, SkyProjection projection,
                           std::vector<Harmonics>& harmonics) {
  const Brick& brick = *bytes.brick;
  const SkySamples& samples = sky_samples(projection);
  const std::vector<Four> basis = basis_of(samples);
  ImageSink<false> sink;
  std::uint32_t image[kMostWords];
  for (std::size_t i = 0; i < brick.probes.size(); ++i) {
    Four sums = {};
    for (int octant = 0; octant < kOctants; ++octant) {
      const Probe& probe = brick.probes[i];
      const auto nearest = [&](int corner, int axis) {
        return kReach + corner - (octant >> axis & 1);
      };
      if (brick.filled({nearest(probe.x, 0), nearest(probe.y, 1), nearest(probe.z, 2)})) continue;
      if (projection == SkyProjection::kFaces)
        merge_octant<3>(bytes, probe, octant, images_of(projection).data(), image);
      else
        merge_octant<1>(bytes, probe, octant, images_of(projection).data(), image);
      sink.take(brick.first_probe + i, octant, reinterpret_cast<std::int32_t*>(image),
                samples.words, 1);
      const Four seen = add_up(samples, basis, image);
      for (int h = 0; h < kHarmonics; ++h) sums[h] += is_negative(h, octant) ? -seen[h] : seen[h];
    }
    for (std::size_t h = 0; h < kHarmonics; ++h)
      harmonics[brick.first_probe + i][h] =
          static_cast<float>(sums[h]) * static_cast<float>(samples.scale[h]);
  }
  return sink.hash();
}

}  // namespace lanescope::benchmarks
