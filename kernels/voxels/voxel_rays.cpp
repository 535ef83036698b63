// SPDX-License-Identifier: MIT
#include "kernels/voxels/voxel_rays.h"

#include <algorithm>

#include "kernels/voxels/counters.h"
#include "kernels/voxels/options.h"
#include "kernels/voxels/probe_field.h"
#include "kernels/voxels/probe_views.h"
#include "workloads/voxels/workload.h"

namespace lanescope {
namespace {

/// A cube of an octant, by its distance from the corner along each axis, in the brick.
Cube cube_at(const Probe& probe, int octant, const std::array<int, 3>& away) {
  const auto place = [&](int corner, std::size_t axis) {
    const bool falls = octant >> axis & 1;
    return kReach + corner + (falls ? -1 - away[axis] : away[axis]);
  };
  return {place(probe.x, 0), place(probe.y, 1), place(probe.z, 2)};
}

/// A megacube of an octant likewise: of its cubes the one nearest to the origin, relative to that
/// of the brick.
Cube megacube_at(const Probe& probe, int octant, const std::array<int, 3>& away) {
  const auto place = [&](int corner, std::size_t axis) {
    const bool falls = octant >> axis & 1;
    return corner + kMegaCube * (falls ? -1 - away[axis] : away[axis]);
  };
  return {place(probe.x, 0), place(probe.y, 1), place(probe.z, 2)};
}

int farthest(const std::array<int, 3>& away) { return *std::max_element(away.begin(), away.end()); }

/// Walks the places that a ray from the origin runs through, in order. Returns whether one is
/// filled that is less than `reach` away along each axis.
template <class IsFilled>
bool meets_filled(const SampleDirection& direction, int reach, const IsFilled& is_filled) {
  std::array<int, 3> away{};
  while (true) {
    if (is_filled(away)) return true;
    // The wall that comes next is at (away + 1) / direction; walls at one place are crossed at
    // once.
    std::size_t nearest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if ((away[axis] + 1) * direction[nearest] < (away[nearest] + 1) * direction[axis])
        nearest = axis;
    const int wall = away[nearest] + 1, along = direction[nearest];
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((away[axis] + 1) * along == wall * direction[axis]) ++away[axis];
    if (farthest(away) == reach) return false;
  }
}

bool is_blocked(const Brick& brick, const Probe& probe, int octant) {
  return brick.filled(cube_at(probe, octant, {0, 0, 0}));
}

std::vector<std::int32_t> render(const Brick& brick, const Probe& probe, int octant,
                                 const SkySamples& samples) {
  std::vector<std::int32_t> image(static_cast<std::size_t>(samples.words));
  for (std::size_t s = 0; s < samples.directions.size(); ++s)
    if (is_occluded(brick, probe, octant, samples.directions[s]))
      image[s / kWordBits] |= static_cast<std::int32_t>(1u << s % kWordBits);
  return image;
}

void add_up(const SkySamples& samples, const std::vector<std::int32_t>& image, int octant,
            std::array<double, kHarmonics>& sums) {
  for (std::size_t s = 0; s < samples.directions.size(); ++s) {
    if (image[s / kWordBits] >> s % kWordBits & 1) continue;
    for (int h = 0; h < kHarmonics; ++h) {
      const auto i = static_cast<std::size_t>(h);
      const double worth = samples.worth[i][s] * samples.scale[i];
      sums[i] += is_negative(h, octant) ? -worth : worth;
    }
  }
}

class VoxelRays final : public Execution {
 public:
  explicit VoxelRays(const Launch& launch)
      : field_(static_cast<ProbeField&>(launch.output)),
        samples_(sky_samples(projection_of(launch.arguments))) {}

  void run(const Work& work) override {
    const auto& brick = static_cast<const Brick&>(work);
    sink_.counts[kProbes] += brick.probes.size();
    for (std::size_t i = 0; i < brick.probes.size(); ++i) render_probe(brick, i);
  }

  KernelResult result() const override {
    KernelResult result;
    result.counts = Counts(1, 0);
    result.counters.assign(sink_.counts.begin(), sink_.counts.begin() + kCubesMerged);
    result.results_hash = sink_.hash();
    return result;
  }

 private:
  void render_probe(const Brick& brick, std::size_t i) {
    const std::uint64_t number = brick.first_probe + i;
    const auto seen =
        sky_seen(brick, brick.probes[i], samples_, [&](int octant, const std::int32_t* words) {
          if (words)
            sink_.take(number, octant, words, samples_.words, 1);
          else
            ++sink_.counts[kOctantsBlocked];
        });
    Harmonics harmonics;
    for (std::size_t h = 0; h < kHarmonics; ++h) harmonics[h] = static_cast<float>(seen[h]);
    field_.write(number, harmonics);
  }

  ProbeField& field_;
  const SkySamples& samples_;
  ImageSink<true> sink_;
};

std::unique_ptr<Execution> start(const Launch& launch) {
  return std::make_unique<VoxelRays>(launch);
}

}  // namespace

bool is_occluded(const Brick& brick, const Probe& probe, int octant,
                 const SampleDirection& direction) {
  if (meets_filled(direction, kReach,
                   [&](const auto& away) { return brick.filled(cube_at(probe, octant, away)); }))
    return true;
  return brick.has_megacubes() && meets_filled(direction, kReach, [&](const auto& away) {
           return farthest(away) >= kMegaSkipped &&
                  brick.mega_filled(megacube_at(probe, octant, away));
         });
}

bool is_occluded_by(const World& world, Cube corner, int octant, const SampleDirection& direction) {
  const auto place = [&](int at, std::size_t axis, int away) {
    return octant >> axis & 1 ? at - 1 - away : at + away;
  };
  const Cube size = world.size();
  return meets_filled(direction, std::max({size.x, size.y, size.z}), [&](const auto& away) {
    return world.filled(
        {place(corner.x, 0, away[0]), place(corner.y, 1, away[1]), place(corner.z, 2, away[2])});
  });
}

std::array<double, kHarmonics> sky_seen(const Brick& brick, const Probe& probe,
                                        const SkySamples& samples, const TakeImage& take) {
  std::array<double, kHarmonics> sums{};
  for (int octant = 0; octant < kOctants; ++octant) {
    if (is_blocked(brick, probe, octant)) {
      if (take) take(octant, nullptr);
      continue;
    }
    const std::vector<std::int32_t> image = render(brick, probe, octant, samples);
    if (take) take(octant, image.data());
    add_up(samples, image, octant, sums);
  }
  return sums;
}

extern const Kernel k_voxel_rays;
const Kernel k_voxel_rays{
    .name = "voxel_rays",
    .summary = "the scalar reference: a ray for each sample, and harmonics in double precision",
    .workload = &w_voxels,
    .is_oracle = true,
    .counters = std::span(kProbeCounters).first<kCubesMerged>(),
    .sums = kProbeSums,
    .metrics = std::span(kProbeMetrics).first<3>(),
    .element = kProbeElement,
    .open = open_probe_field,
    .output_bytes = probe_field_bytes,
    .start = start,
    .views = kProbeViews,
};

}  // namespace lanescope
