// SPDX-License-Identifier: MIT
#include "kernels/voxels/cube_images.h"

#include <algorithm>

namespace lanescope {
namespace {

/// The ray from the origin meets the inside of the cube [x, x + 1] x [y, y + 1] x [z, z + 1]: the
/// last of its three slabs is entered before the first is left.
bool covers(const std::array<int, 3>& cube, const SampleDirection& direction) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      if (cube[a] * direction[b] >= (cube[b] + 1) * direction[a]) return false;
  return true;
}

CubeImages render(const SkySamples& samples) {
  CubeImages all;
  all.words = samples.words;
  const auto words = static_cast<std::size_t>(samples.words);
  for (const OctantRow& row : octant_rows())
    for (int x = 0; x < kReach; ++x) {
      std::vector<std::uint32_t> image(words);
      for (std::size_t s = 0; s < samples.directions.size(); ++s)
        if (covers({x, row.y, row.z}, samples.directions[s]))
          image[s / kWordBits] |= 1u << s % kWordBits;
      const std::size_t first = all.parts.size();
      for (std::uint32_t w = 0; w < words; ++w)
        if (image[w] != 0) all.parts.push_back({w, image[w]});
      all.parts_of_cube.push_back(static_cast<std::uint32_t>(first));
      all.parts_of_cube.push_back(static_cast<std::uint32_t>(all.parts.size() - first));
      all.images.insert(all.images.end(), image.begin(), image.end());
    }
  return all;
}

}  // namespace

const CubeImages& cube_images(SkyProjection projection) {
  static const CubeImages faces = render(sky_samples(SkyProjection::kFaces));
  static const CubeImages directions = render(sky_samples(SkyProjection::kDirections));
  return projection == SkyProjection::kFaces ? faces : directions;
}

const std::vector<OctantRow>& octant_rows() {
  static const std::vector<OctantRow> rows = [] {
    std::vector<OctantRow> all;
    for (int z = 0; z < kReach; ++z)
      for (int y = 0; y < kReach; ++y) all.push_back({y, z});
    std::stable_sort(all.begin(), all.end(), [](OctantRow a, OctantRow b) {
      return a.y * a.y + a.z * a.z < b.y * b.y + b.z * b.z;
    });
    return all;
  }();
  return rows;
}

}  // namespace lanescope
