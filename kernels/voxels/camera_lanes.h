// SPDX-License-Identifier: MIT
// What programs share in which a lane is a corner: an image is a vector for each of its words.
#pragma once

#include "kernels/voxels/stages.h"

namespace lanescope {

/// A sum for each harmonic, of each lane.
template <class Vm>
struct HarmonicVectors {
  typename Vm::Int of[kHarmonics];
};

template <class Vm>
void clear(typename Vm::Site& site, typename Vm::Lanes active, HarmonicVectors<Vm>& sums) {
  auto on = site.on(active);
  host::unroll<kHarmonics>([&](auto h)
                               LANESCOPE_INLINE_LAMBDA { sums.of[h] = isa::broadcast(on, 0); });
}

template <class Vm>
void clear_images(typename Vm::Site& site, typename Vm::Lanes active, typename Vm::Int* image,
                  int words) {
  for (int w = 0; w < words; ++w) {
    auto on = site.on(active);
    image[w] = isa::broadcast(on, 0);
  }
}

/// The lanes in which every sample is occluded.
template <class Vm>
typename Vm::Lanes full_images(typename Vm::Site& site, typename Vm::Lanes active,
                               const typename Vm::Int* image, int words) {
  using namespace isa;
  typename Vm::Int common = image[0];
  for (int w = 1; w < words; ++w) {
    auto on = site.on(active);
    common = bit_and(on, common, image[w]);
  }
  auto on = site.on(active);
  return cmp_eq(on, common, -1);
}

/// Hands finished images over. `place(lane)` is the probe's number in the scene, and the octant.
template <class Vm, class Place>
void take_images(ImageSink<Vm::kCounted>& sink, typename Vm::Lanes active,
                 const typename Vm::Int* image, int words, const Place& place) {
  std::int32_t lanes[kMostWords][Vm::kLanes];
  for (int w = 0; w < words; ++w) {
    const auto word = Vm::look(image[w]).lanes();
    std::copy(word.begin(), word.end(), lanes[w]);
  }
  for_each_lane(active, [&](int lane) {
    const auto [probe, octant] = place(lane);
    sink.take(probe, octant, &lanes[0][lane], words, Vm::kLanes);
  });
}

/// *Project* as the article has it: each sample that sees the sky selects what it is worth to each
/// harmonic, and adds it up.
template <class Vm>
HarmonicVectors<Vm> selected_worths(typename Vm::Site& site, typename Vm::Lanes active,
                                    const SkySamples& samples, const typename Vm::Int* image) {
  using namespace isa;
  HarmonicVectors<Vm> seen;
  clear<Vm>(site, active, seen);
  for (int w = 0; w < samples.words; ++w)
    for (int b = 0; b < kWordBits; ++b) {
      const auto s = static_cast<std::size_t>(w * kWordBits + b);
      auto on = site.on(active);
      const auto sky = cmp_eq(on, bit_and(on, image[w], std::int32_t(1u << b)), 0);
      host::unroll<kHarmonics>([&](auto h) LANESCOPE_INLINE_LAMBDA {
        auto& sum = seen.of[h];
        sum = select(on, sky, add(on, sum, samples.worth[h][s]), sum);
      });
    }
  return seen;
}

/// *Project* by counting: the samples of two words that see the sky.
template <class Vm>
HarmonicVectors<Vm> counted_samples(typename Vm::Site& site, typename Vm::Lanes active,
                                    const typename Vm::Int* image) {
  using namespace isa;
  HarmonicVectors<Vm> seen;
  auto on = site.on(active);
  host::unroll<kHarmonics>([&](auto h) LANESCOPE_INLINE_LAMBDA {
    const auto occluded =
        add(on, popcount(on, image[kCountedWords * h]), popcount(on, image[kCountedWords * h + 1]));
    seen.of[h] = sub(on, kCountedWords * kWordBits, occluded);
  });
  return seen;
}

/// What each lane's image is worth to each harmonic.
template <class Vm>
HarmonicVectors<Vm> seen_by(typename Vm::Site& site, typename Vm::Lanes active,
                            const SkySamples& samples, const typename Vm::Int* image) {
  return samples.by_counting ? counted_samples<Vm>(site, active, image)
                             : selected_worths<Vm>(site, active, samples, image);
}

}  // namespace lanescope
