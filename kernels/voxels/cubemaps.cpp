// SPDX-License-Identifier: MIT
#include "kernels/voxels/cubemaps.h"

#include <algorithm>
#include <bitset>

#include "kernels/voxels/voxel_rays.h"
#include "simulator/base/random.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

constexpr int kFaceSize = 32;  ///< Pixels of a face of the whole cubemap: two octants either way.
constexpr int kScale = 3;
constexpr int kColumns = 4, kRows = 3;  ///< Cubemaps of the picture, and faces of an unfolded one.
constexpr int kGap = 12;
constexpr int kMapWidth = 4 * kFaceSize * kScale, kMapHeight = 3 * kFaceSize * kScale;

constexpr Colour kPaper{24, 24, 27}, kSky{236, 240, 246}, kBlocked{58, 66, 84};

using Axes = std::array<int, 3>;

/// A face as an unfolded cube shows it: in the column and row, with these directions.
struct Face {
  int column, row;
  Axes forward, right, down;
};
constexpr std::array<Face, 6> kFaces{{
    {0, 1, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {1, 1, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
    {2, 1, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {3, 1, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
    {1, 0, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
    {1, 2, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
}};

using Pixels = std::bitset<6 * kFaceSize * kFaceSize>;  ///< Set where the sky is hidden.

constexpr std::size_t pixel(std::size_t face, int x, int y) {
  return (face * kFaceSize + static_cast<std::size_t>(y)) * kFaceSize + static_cast<std::size_t>(x);
}

bool is_hidden(const Brick& brick, const Probe& probe, const Face& face, int x, int y) {
  SampleDirection direction;
  int octant = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int along = kFaceSize * face.forward[axis] + (2 * x + 1 - kFaceSize) * face.right[axis] +
                      (2 * y + 1 - kFaceSize) * face.down[axis];
    octant |= (along < 0) << axis;
    direction[axis] = std::abs(along);
  }
  return is_occluded(brick, probe, octant, direction);
}

Pixels cubemap(const Brick& brick, const Probe& probe) {
  Pixels pixels;
  for (std::size_t face = 0; face < kFaces.size(); ++face)
    for (int y = 0; y < kFaceSize; ++y)
      for (int x = 0; x < kFaceSize; ++x)
        pixels[pixel(face, x, y)] = is_hidden(brick, probe, kFaces[face], x, y);
  return pixels;
}

/// Cubemaps of a dozen probes, spread over all.
class Cubemaps final : public Output {
 public:
  explicit Cubemaps(std::uint64_t probe_count) : probe_count_(probe_count) {}

  /// Takes those of a brick's probes that the picture shows.
  void take(const Brick& brick) {
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      const std::uint64_t wanted = (2 * i + 1) * probe_count_ / (2 * maps_.size());
      const std::uint64_t place = wanted - brick.first_probe;
      if (wanted >= brick.first_probe && place < brick.probes.size())
        maps_[i] = cubemap(brick, brick.probes[place]);
    }
  }

  std::uint64_t hash() const override {
    std::uint64_t hash = 0;
    for (const Pixels& map : maps_) hash = mix64(hash ^ std::hash<Pixels>()(map));
    return hash;
  }

  std::optional<Raster> picture() const override {
    Raster raster;
    raster.width_px = kColumns * (kMapWidth + kGap) + kGap;
    raster.height_px = kRows * (kMapHeight + kGap) + kGap;
    raster.pixels.assign(static_cast<std::size_t>(raster.width_px * raster.height_px), kPaper);
    for (std::size_t i = 0; i < maps_.size(); ++i) draw(raster, i);
    return raster;
  }

 private:
  void draw(Raster& raster, std::size_t map) const {
    const int left = kGap + static_cast<int>(map) % kColumns * (kMapWidth + kGap);
    const int top = kGap + static_cast<int>(map) / kColumns * (kMapHeight + kGap);
    for (std::size_t f = 0; f < kFaces.size(); ++f)
      for (int y = 0; y < kFaceSize * kScale; ++y)
        for (int x = 0; x < kFaceSize * kScale; ++x) {
          const int column = left + kFaces[f].column * kFaceSize * kScale + x;
          const int row = top + kFaces[f].row * kFaceSize * kScale + y;
          raster.pixels[static_cast<std::size_t>(row * raster.width_px + column)] =
              maps_[map][pixel(f, x / kScale, y / kScale)] ? kBlocked : kSky;
        }
  }

  std::uint64_t probe_count_;
  std::array<Pixels, kColumns * kRows> maps_;
};

class TakeCubemaps final : public Execution {
 public:
  explicit TakeCubemaps(Cubemaps& maps) : maps_(maps) {}
  void run(const Work& work) override { maps_.take(static_cast<const Brick&>(work)); }
  KernelResult result() const override { return {}; }

 private:
  Cubemaps& maps_;
};

}  // namespace

std::unique_ptr<Output> open_cubemaps(const Arguments& /*arguments*/, const Source& source) {
  return std::make_unique<Cubemaps>(static_cast<const VoxelSource&>(source).probe_count());
}

std::uint64_t cubemaps_bytes(const Arguments& /*arguments*/) { return sizeof(Cubemaps); }

std::unique_ptr<Execution> start_cubemaps(const Launch& launch) {
  return std::make_unique<TakeCubemaps>(static_cast<Cubemaps&>(launch.output));
}

}  // namespace lanescope
