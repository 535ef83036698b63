// SPDX-License-Identifier: MIT
// The bricks of a world.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "workloads/voxels/brick.h"
#include "workloads/voxels/megacubes.h"
#include "workloads/voxels/options.h"
#include "workloads/voxels/world.h"
#include "workloads/work.h"

namespace lanescope {

/// Of a source, in this order.
inline constexpr std::array<CounterInfo, 3> kWorldCounters{
    {{"bricks", "bricks that have a probe", "bricks"},
     {"cubes_seen", "cubes of the world that the corners of a brick may see, summed over bricks",
      "cubes"},
     {"cubes_seen_filled", "filled cubes of these", "cubes"}}};

/// Hands out the probes of bricks: a segment is a brick that has some. Probes are the corners of
/// the lattice where a filled cube meets an empty one.
class VoxelSource final : public Source {
 public:
  /// Of the options, those of pieces and of megacubes count.
  explicit VoxelSource(std::shared_ptr<const World> world, const WorldOptions& options = {});

  int segment_count() const override { return static_cast<int>(bricks_.size()); }
  std::vector<std::uint64_t> produce(int segment, const WorkSink& sink) const override;
  std::vector<std::string> notes() const override;

  const std::shared_ptr<const World>& world() const { return world_; }
  std::uint64_t probe_count() const { return probe_count_; }

  /// Every probe of the world with its number, in no order that matters.
  void for_each_probe(const std::function<void(Cube corner, std::uint64_t number)>& visit) const;

 private:
  struct Place {
    Cube origin;
    std::uint64_t first_probe;
  };

  std::vector<Probe> probes_of(Cube origin) const;
  /// Fills the cubes of a brick. Returns the counters.
  std::vector<std::uint64_t> fill(Brick& brick) const;
  void fill_megacubes(Brick& brick) const;

  std::shared_ptr<const World> world_;
  std::size_t piece_probes_;
  std::optional<Megacubes> megacubes_;
  std::vector<Place> bricks_;
  std::uint64_t probe_count_ = 0;
};

}  // namespace lanescope
