// SPDX-License-Identifier: MIT
// How far off the light is that probes give: by their samples, by harmonics that end at the first
// order, and by what lies beyond their reach.
#include <cmath>
#include <numbers>

#include "kernels/voxels/counters.h"
#include "kernels/voxels/options.h"
#include "kernels/voxels/probe_field.h"
#include "kernels/voxels/voxel_rays.h"
#include "workloads/voxels/workload.h"

namespace lanescope {
namespace {

using SkyHarmonics = std::array<double, kHarmonics>;

const double kConstant = std::sqrt(1.0 / (4.0 * std::numbers::pi));
const double kLinear = std::sqrt(3.0 / (4.0 * std::numbers::pi));

/// Surfaces to be lit: towards each axis, either way.
constexpr int kNormals = 6;
/// What a surface under an open sky receives.
constexpr double kOpenLight = std::numbers::pi;
/// Squares of errors are counted in this unit.
constexpr double kUnit = 1e-9;

enum ErrorCounter : std::size_t {
  kErrorProbes,
  kLights,
  kSquaredSampling,
  kSquaredOrder,
  kSquaredTotal,
  kSquaredHarmonics,
  kSquaredReach,
  kLeaked,
  kLost,
  kErrorCounterCount,
};

constexpr std::array<CounterInfo, kErrorCounterCount> kErrorCounters{{
    {"probes", "corners that were measured", "probes"},
    {"lights", "surfaces lit: six at each probe, towards each axis either way", "lights"},
    {"squared_sampling_error",
     "squares of errors of light by harmonics of the samples, against harmonics of 4096 rays",
     "1e-9 open skies squared"},
    {"squared_order_error",
     "squares of errors of light by harmonics of 4096 rays, against the light of the rays",
     "1e-9 open skies squared"},
    {"squared_total_error",
     "squares of errors of light by harmonics of the samples, against the light of 4096 rays",
     "1e-9 open skies squared"},
    {"squared_harmonics_error",
     "squares of distances of harmonics of the samples from those of 4096 rays",
     "1e-9 harmonics of an open sky squared"},
    {"squared_reach_error",
     "squares of errors of light of 4096 rays that end where probes do, against rays through the "
     "whole world",
     "1e-9 open skies squared"},
    {"light_leaked", "light of rays that end where probes do, above that of the whole world",
     "1e-9 open skies"},
    {"light_lost", "light of rays that end where probes do, below that of the whole world",
     "1e-9 open skies"},
}};

constexpr std::array<MetricInfo, 7> kErrorMetrics{{
    {"mean_square_sampling_error", "of the light, by the samples", "squared_sampling_error",
     "lights"},
    {"mean_square_order_error", "of the light, by ending at the first order", "squared_order_error",
     "lights"},
    {"mean_square_total_error", "of the light, by both", "squared_total_error", "lights"},
    {"mean_square_harmonics_error", "of the harmonics, by the samples", "squared_harmonics_error",
     "probes"},
    {"mean_square_reach_error", "of the light, by what lies beyond the reach",
     "squared_reach_error", "lights"},
    {"mean_light_leaked", "light that bodies beyond the reach would hide", "light_leaked",
     "lights"},
    {"mean_light_lost", "light that megacubes hide and the world does not", "light_lost", "lights"},
}};

/// What 4096 rays see: the light of each surface, and harmonics.
struct Seen {
  std::array<double, kNormals> light{};
  SkyHarmonics harmonics{};
};

/// `is_hidden(octant, direction)` ends a ray.
template <class IsHidden>
Seen by_even_rays(const IsHidden& is_hidden) {
  constexpr double kShare = 4 * std::numbers::pi / (kOctants * kEvenDirections);
  Seen seen;
  for (int octant = 0; octant < kOctants; ++octant)
    for (const SampleDirection& direction : even_directions()) {
      if (is_hidden(octant, direction)) continue;
      double squared = 0;
      for (const std::int32_t component : direction) squared += double(component) * component;
      seen.harmonics[0] += kShare * kConstant;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool falls = octant >> axis & 1;
        const double cosine = direction[axis] / std::sqrt(squared);
        seen.light[2 * axis + falls] += kShare * cosine;
        seen.harmonics[axis + 1] += (falls ? -kShare : kShare) * kLinear * cosine;
      }
    }
  return seen;
}

/// The light of each surface from harmonics: each order is weighted by that of a clamped cosine, pi
/// and 2 pi / 3 (Ramamoorthi and Hanrahan 2001).
std::array<double, kNormals> light_of(const SkyHarmonics& harmonics) {
  std::array<double, kNormals> light;
  for (std::size_t normal = 0; normal < kNormals; ++normal) {
    const double along = harmonics[normal / 2 + 1] * (normal % 2 ? -1 : 1);
    light[normal] =
        std::numbers::pi * kConstant * harmonics[0] + 2 * std::numbers::pi / 3 * kLinear * along;
  }
  return light;
}

template <std::size_t kCount>
std::uint64_t squared_distance(const std::array<double, kCount>& a,
                               const std::array<double, kCount>& b, double one) {
  double sum = 0;
  for (std::size_t i = 0; i < kCount; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return static_cast<std::uint64_t>(std::llround(sum / (one * one) / kUnit));
}

class SkyError final : public Execution {
 public:
  explicit SkyError(const Launch& launch)
      : field_(static_cast<ProbeField&>(launch.output)),
        samples_(sky_samples(projection_of(launch.arguments))),
        measured_every_(static_cast<std::uint64_t>(
            decoded(error_parameters(), launch.arguments).measured_every)) {}

  void run(const Work& work) override {
    const auto& brick = static_cast<const Brick&>(work);
    for (std::size_t i = 0; i < brick.probes.size(); ++i)
      if ((brick.first_probe + i) % measured_every_ == 0) measure(brick, i);
  }

  KernelResult result() const override {
    KernelResult result;
    result.counts = Counts(1, 0);
    result.counters.assign(counts_.begin(), counts_.end());
    return result;
  }

 private:
  void measure(const Brick& brick, std::size_t i) {
    const Probe& probe = brick.probes[i];
    const Seen exact = by_even_rays([&](int octant, const SampleDirection& direction) {
      return is_occluded(brick, probe, octant, direction);
    });
    measure_reach(brick, probe, exact);
    const SkyHarmonics sampled = sky_seen(brick, probe, samples_, {});
    const auto light = light_of(sampled), light_of_exact = light_of(exact.harmonics);
    ++counts_[kErrorProbes];
    counts_[kLights] += kNormals;
    counts_[kSquaredSampling] += squared_distance(light, light_of_exact, kOpenLight);
    counts_[kSquaredOrder] += squared_distance(light_of_exact, exact.light, kOpenLight);
    counts_[kSquaredTotal] += squared_distance(light, exact.light, kOpenLight);
    counts_[kSquaredHarmonics] += squared_distance(sampled, exact.harmonics, 1 / kConstant);
    Harmonics harmonics;
    for (std::size_t h = 0; h < kHarmonics; ++h)
      harmonics[h] = static_cast<float>(exact.harmonics[h]);
    field_.write(brick.first_probe + i, harmonics);
  }

  void measure_reach(const Brick& brick, const Probe& probe, const Seen& seen) {
    const Cube corner{brick.origin.x + probe.x, brick.origin.y + probe.y, brick.origin.z + probe.z};
    const Seen whole = by_even_rays([&](int octant, const SampleDirection& direction) {
      return is_occluded_by(field_.world(), corner, octant, direction);
    });
    counts_[kSquaredReach] += squared_distance(seen.light, whole.light, kOpenLight);
    for (std::size_t normal = 0; normal < kNormals; ++normal) {
      const double more = (seen.light[normal] - whole.light[normal]) / kOpenLight;
      counts_[more > 0 ? kLeaked : kLost] +=
          static_cast<std::uint64_t>(std::llround(std::abs(more) / kUnit));
    }
  }

  ProbeField& field_;
  const SkySamples& samples_;
  std::uint64_t measured_every_;
  std::array<std::uint64_t, kErrorCounterCount> counts_{};
};

std::unique_ptr<Execution> start(const Launch& launch) {
  return std::make_unique<SkyError>(launch);
}

}  // namespace

extern const Kernel k_sky_error;
const Kernel k_sky_error{
    .name = "sky_error",
    .summary = "measures what samples and harmonics miss, against 4096 rays of each probe",
    .workload = &w_voxels,
    .parameters = joined(error_parameters()),
    .counters = kErrorCounters,
    .metrics = kErrorMetrics,
    .element = kProbeElement,
    .open = open_probe_field,
    .output_bytes = probe_field_bytes,
    .start = start,
};

}  // namespace lanescope
