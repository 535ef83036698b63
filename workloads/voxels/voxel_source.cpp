// SPDX-License-Identifier: MIT
#include "workloads/voxels/voxel_source.h"

#include <algorithm>

namespace lanescope {
namespace {

/// Whether some of the eight cubes at a corner are filled, and some are not.
bool is_surface(const World& world, Cell corner) {
  int filled = 0;
  for (int i = 0; i < 8; ++i)
    filled += world.filled(
        {corner.x - (i & 1), corner.y - (i >> 1 & 1), corner.z - (i >> 2)});
  return filled != 0 && filled != 8;
}

/// Calls `visit` with the first corner of each brick along an axis.
template <class Visit>
void for_bricks(int first, int last, const Visit& visit) {
  for (int corner = first; corner <= last; corner += kBrickCorners) visit(corner);
}

}  // namespace

VoxelSource::VoxelSource(std::shared_ptr<const World> world) : world_(std::move(world)) {
  const Cell size = world_->size();
  const int margin = world_->margin;
  for_bricks(margin, size.z - margin, [&](int z) {
    for_bricks(margin, size.x - margin, [&](int x) {
      std::vector<Place> column;
      for_bricks(margin, size.y - margin, [&](int y) {
        const std::size_t count = probes_of({x, y, z}).size();
        if (count == 0) return;
        column.push_back({{x, y, z}, probe_count_});
        probe_count_ += count;
      });
      if (!column.empty()) columns_.push_back(std::move(column));
    });
  });
}

std::vector<Probe> VoxelSource::probes_of(Cell origin) const {
  const Cell size = world_->size();
  const auto end = [&](int first, int cubes) {
    return std::min(kBrickCorners, cubes - world_->margin - first + 1);
  };
  std::vector<Probe> probes;
  for (int z = 0; z < end(origin.z, size.z); ++z)
    for (int y = 0; y < end(origin.y, size.y); ++y)
      for (int x = 0; x < end(origin.x, size.x); ++x)
        if (is_surface(*world_, {origin.x + x, origin.y + y, origin.z + z}))
          probes.push_back({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                            static_cast<std::uint8_t>(z)});
  return probes;
}

std::vector<std::uint64_t> VoxelSource::produce(int segment, const WorkSink& sink) const {
  Brick brick;
  brick.segment = static_cast<std::uint64_t>(segment);
  std::uint64_t filled = 0;
  const auto& column = columns_[static_cast<std::size_t>(segment)];
  for (const Place& place : column) {
    brick.origin = place.origin;
    brick.first_probe = place.first_probe;
    brick.probes = probes_of(place.origin);
    brick.clear();
    for (int z = 0; z < kBrickCubes; ++z)
      for (int y = 0; y < kBrickCubes; ++y)
        for (int x = 0; x < kBrickCubes; ++x)
          if (world_->filled({place.origin.x - kReach + x, place.origin.y - kReach + y,
                              place.origin.z - kReach + z})) {
            brick.fill({x, y, z});
            ++filled;
          }
    sink(brick);
    ++brick.ordinal;
  }
  constexpr std::uint64_t kSeen = std::uint64_t{kBrickCubes} * kBrickCubes * kBrickCubes;
  return {column.size(), kSeen * column.size(), filled};
}

std::vector<std::string> VoxelSource::notes() const {
  if (probe_count_ != 0) return {};
  return {"the world has no probe: no filled cube meets an empty one"};
}

void VoxelSource::for_each_probe(
    const std::function<void(Cell corner, std::uint64_t number)>& visit) const {
  for (const auto& column : columns_)
    for (const Place& place : column) {
      std::uint64_t number = place.first_probe;
      for (const Probe& probe : probes_of(place.origin))
        visit({place.origin.x + probe.x, place.origin.y + probe.y, place.origin.z + probe.z},
              number++);
    }
}

}  // namespace lanescope
