// SPDX-License-Identifier: MIT
#include "workloads/voxels/voxel_source.h"

#include <algorithm>

namespace lanescope {
namespace {

/// Whether some of the eight cubes at a corner are filled, and some are not.
bool is_surface(const World& world, Cube corner) {
  int filled = 0;
  for (int i = 0; i < 8; ++i)
    filled += world.filled({corner.x - (i & 1), corner.y - (i >> 1 & 1), corner.z - (i >> 2)});
  return filled != 0 && filled != 8;
}

/// Calls `visit` with the first corner of each brick along an axis.
template <class Visit>
void for_bricks(int first, int last, const Visit& visit) {
  for (int corner = first; corner <= last; corner += kBrickCorners) visit(corner);
}

}  // namespace

VoxelSource::VoxelSource(std::shared_ptr<const World> world, const WorldOptions& options)
    : world_(std::move(world)), piece_probes_(static_cast<std::size_t>(options.piece_probes)) {
  if (options.levels == 2) megacubes_.emplace(*world_, options.mega_fill.value_or(kMegaFill));
  const Cube size = world_->size();
  const int margin = world_->margin;
  for_bricks(margin, size.z - margin, [&](int z) {
    for_bricks(margin, size.x - margin, [&](int x) {
      for_bricks(margin, size.y - margin, [&](int y) {
        const std::size_t count = probes_of({x, y, z}).size();
        if (count == 0) return;
        bricks_.push_back({{x, y, z}, probe_count_});
        probe_count_ += count;
      });
    });
  });
}

std::vector<Probe> VoxelSource::probes_of(Cube origin) const {
  const Cube size = world_->size();
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
  const Place& place = bricks_[static_cast<std::size_t>(segment)];
  Brick brick;
  brick.segment = static_cast<std::uint64_t>(segment);
  brick.origin = place.origin;
  brick.first_probe = place.first_probe;
  const std::vector<std::uint64_t> counters = fill(brick);
  const std::vector<Probe> probes = probes_of(place.origin);
  for (std::size_t first = 0; first < probes.size(); first += piece_probes_) {
    const auto begin = probes.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(piece_probes_, probes.size() - first);
    brick.probes.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    sink(brick);
    brick.first_probe += count;
    ++brick.ordinal;
  }
  return counters;
}

std::vector<std::uint64_t> VoxelSource::fill(Brick& brick) const {
  std::uint64_t seen = 0, filled = 0;
  brick.clear(megacubes_.has_value());
  if (megacubes_) fill_megacubes(brick);
  for (int z = 0; z < kBrickCubes; ++z)
    for (int y = 0; y < kBrickCubes; ++y)
      for (int x = 0; x < kBrickCubes; ++x) {
        const Cube cube{brick.origin.x - kReach + x, brick.origin.y - kReach + y,
                        brick.origin.z - kReach + z};
        if (!world_->contains(cube)) continue;
        ++seen;
        if (!world_->filled(cube)) continue;
        ++filled;
        brick.fill({x, y, z});
      }
  return {1, seen, filled};
}

void VoxelSource::fill_megacubes(Brick& brick) const {
  constexpr int kFirst = -kMegaCube * kReach, kEnd = kFirst + kMegaPlaces;
  for (int z = kFirst; z < kEnd; ++z)
    for (int y = kFirst; y < kEnd; ++y)
      for (int x = kFirst; x < kEnd; ++x)
        if (megacubes_->opaque({brick.origin.x + x, brick.origin.y + y, brick.origin.z + z}))
          brick.fill_mega({x, y, z});
}

std::vector<std::string> VoxelSource::notes() const {
  if (probe_count_ != 0) return {};
  return {"the world has no probe: no filled cube meets an empty one"};
}

void VoxelSource::for_each_probe(
    const std::function<void(Cube corner, std::uint64_t number)>& visit) const {
  for (const Place& place : bricks_) {
    std::uint64_t number = place.first_probe;
    for (const Probe& probe : probes_of(place.origin))
      visit({place.origin.x + probe.x, place.origin.y + probe.y, place.origin.z + probe.z},
            number++);
  }
}

}  // namespace lanescope
