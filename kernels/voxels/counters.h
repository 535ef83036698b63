// SPDX-License-Identifier: MIT
// What the kernels of this kind count beside instructions and lanes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "kernels/kernel.h"
#include "kernels/voxels/sky_samples.h"
#include "simulator/base/random.h"

namespace lanescope {

enum ProbeCounter : std::size_t {
  kProbes,
  kOctantsRendered,
  kOctantsBlocked,
  kOctantsFull,
  kSamplesTaken,
  kSamplesOccluded,
  kCubesMerged,
  kProbeCounterCount,
};

/// In the order of ProbeCounter. The reference has all but the last.
inline constexpr std::array<CounterInfo, kProbeCounterCount> kProbeCounters{{
    {"probes", "corners that were rendered from", "probes"},
    {"octants_rendered", "octants whose nearest cube is empty", "octants"},
    {"octants_blocked", "octants whose nearest cube is filled, and hides all of it", "octants"},
    {"octants_full", "octants rendered in which every sample is occluded", "octants"},
    {"samples_taken", "samples of the octants rendered", "samples"},
    {"samples_occluded", "samples of these that some cube covers", "samples"},
    {"cubes_merged", "images of cubes that were merged into those of octants", "cubes"},
}};

inline constexpr std::string_view kPartsOfOctants[] = {"octants_rendered", "octants_blocked"};
inline constexpr CounterSum kProbeSums[] = {{"probes", kPartsOfOctants, kOctants}};

/// Those that need cubes_merged are last.
inline constexpr std::array<MetricInfo, 4> kProbeMetrics{{
    {"octants_per_probe", "octants rendered for each probe", "octants_rendered", "probes"},
    {"occluded", "share of the samples that some cube covers", "samples_occluded", "samples_taken"},
    {"full", "share of the octants rendered that see no sky", "octants_full", "octants_rendered"},
    {"cubes_per_octant", "cubes merged for each octant rendered", "cubes_merged",
     "octants_rendered"},
}};

inline constexpr Element kProbeElement{"probes", "probe", "probe"};

using ProbeCounts = std::array<std::uint64_t, kProbeCounterCount>;

/// Takes the image of an octant when it is finished: the hash of all of them and, if counted,
/// counters.
template <bool kCounted>
class ImageSink {
 public:
  /// The image of a probe, by its number in the scene, has word w at words[w * stride].
  void take(std::uint64_t probe, int octant, const std::int32_t* words, int count, int stride) {
    std::uint64_t sum = 0;
    int occluded = 0;
    for (int w = 0; w < count; ++w) {
      const auto word = static_cast<std::uint32_t>(words[w * stride]);
      sum += word * (2 * mix64(static_cast<std::uint64_t>(w)) + 1);
      if constexpr (kCounted) occluded += std::popcount(word);
    }
    hash_ += mix64(mix64(probe * kOctants + static_cast<std::uint64_t>(octant)) ^ sum);
    if constexpr (kCounted) {
      ++counts[kOctantsRendered];
      counts[kSamplesTaken] += static_cast<std::uint64_t>(count * kWordBits);
      counts[kSamplesOccluded] += static_cast<std::uint64_t>(occluded);
      counts[kOctantsFull] += occluded == count * kWordBits;
    }
  }
  std::uint64_t hash() const { return hash_; }

  ProbeCounts counts{};

 private:
  std::uint64_t hash_ = 0;
};

}  // namespace lanescope
