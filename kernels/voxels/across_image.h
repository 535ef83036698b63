// SPDX-License-Identifier: MIT
// The article's form: a lane is a word of an image. The scalar unit walks the filled cubes, and the
// image of each is merged by one load and one `or`. A vector that is too short for an image takes
// several; one that is long enough for more holds the images of as many octants, of which each
// merges a cube of its own at a time.
#pragma once

#include "kernels/voxels/image_lanes.h"

namespace lanescope {

template <class Vm>
class AcrossImage {
 public:
  static constexpr std::size_t kStageCount = kProbeStages.size();

  AcrossImage(Vm& vm, const ProbeProgram& program, ImageSink<Vm::kCounted>& sink)
      : vm_(vm),
        samples_(program.samples),
        images_(words_of(program.cubes.images, "images of cubes")),
        octants_at_a_time_(vm.width() / samples_.words >= program.options.least_side_by_side
                               ? vm.width() / samples_.words
                               : 1),
        sink_(sink) {}

  void render(const BrickMemory& brick, Memory<float> harmonics) {
    render_each_octant(vm_, brick, samples_, open_, rendered_, sums_, sink_, harmonics, *this);
  }

  int octants_at_a_time() const { return octants_at_a_time_; }

  /// Renders some octants of the list.
  void render(const BrickMemory& brick, const OpenOctants& open, int first, int count,
              ImageMemory& rendered) {
    using namespace isa;
    Sites sites(vm_);
    for (int i = 0; i < count; ++i)
      walks_[i] = {brick, open.probe(first + i), open.octant(first + i)};
    for_each_part(sites.clearing, count, [&](auto& on, int part, int) LANESCOPE_INLINE_LAMBDA {
      words_[part] = broadcast(on, 0);
    });
    if (count == 1)
      merge_one(sites);
    else
      merge_side_by_side(sites, count);
    for_each_part(sites.storing, count,
                  [&](auto& on, int part, int first_word) LANESCOPE_INLINE_LAMBDA {
                    store(on, rendered.words.memory(), first_word, words_[part]);
                  });
  }

 private:
  using Int = typename Vm::Int;
  using Lanes = typename Vm::Lanes;

  /// Cubes that are merged before it is looked at again whether images are full.
  static constexpr int kCubesBetweenChecks = 12;
  /// Octants whose images fit the widest vector, at the fewest words.
  static constexpr int kMostOctants = 64 / (kHarmonics * kCountedWords);

  struct Sites {
    explicit Sites(Vm& vm)
        : walk(vm),
          clearing(vm.site(kMerge)),
          placing(vm.site(kMerge)),
          merging(vm.site(kMerge)),
          checking(vm.site(kMerge)),
          storing(vm.site(kMerge)) {}
    typename CubeWalk<Vm>::Sites walk;
    typename Vm::Site clearing, placing, merging, checking, storing;
  };

  /// Calls `issue(on, part, first word)` for each vector that holds a part of the images.
  template <class Issue>
  LANESCOPE_INLINE void for_each_part(typename Vm::Site& site, int octants, const Issue& issue) {
    const int words = octants * samples_.words;
    for (int part = 0, first = 0; first < words; ++part, first += vm_.width()) {
      auto on = site.on(vm_.first_n(words - first));
      issue(on, part, first);
    }
  }

  void merge_one(Sites& sites) {
    using namespace isa;
    int unchecked = 0;
    for (int cube; (cube = walks_[0].next(vm_, sites.walk)) >= 0;) {
      const std::int64_t image = std::int64_t{cube} * samples_.words;
      for_each_part(sites.merging, 1, [&](auto& on, int part, int first) LANESCOPE_INLINE_LAMBDA {
        words_[part] = bit_or(on, words_[part], load(on, images_, image + first));
      });
      if constexpr (Vm::kCounted) ++sink_.counts[kCubesMerged];
      if (++unchecked < kCubesBetweenChecks) continue;
      unchecked = 0;
      if (is_full(sites)) return;
    }
  }

  bool is_full(Sites& sites) {
    using namespace isa;
    bool full = true;
    for_each_part(sites.checking, 1, [&](auto& on, int part, int) LANESCOPE_INLINE_LAMBDA {
      full = full && all(on, cmp_eq(on, words_[part], -1));
    });
    return full;
  }

  /// The lanes of the i-th image of a vector.
  Lanes lanes_of(int i) const {
    return Lanes::from_bits(low_bits((i + 1) * samples_.words) & ~low_bits(i * samples_.words));
  }

  /// Each octant merges its next cube: the scalar unit leaves their numbers in memory, and lanes
  /// fetch that of their octant.
  void merge_side_by_side(Sites& sites, int count) {
    using namespace isa;
    const Lanes all_lanes = vm_.first_n(count * samples_.words);
    Int octant, word;
    {
      auto on = sites.placing.on(all_lanes);
      octant = div(on, lane_index(on), samples_.words);
      word = sub(on, lane_index(on), mul(on, octant, samples_.words));
    }
    Lanes busy = all_lanes;
    for (int step = 1; (busy = next_cubes(sites, busy, count)).any(); ++step) {
      {
        auto on = sites.merging.on(busy);
        const auto image = gather(on, first_words_.memory(), octant);
        words_[0] = or_into(on, words_[0], gather(on, images_, add(on, image, word)), words_[0]);
      }
      if (step % kCubesBetweenChecks == 0) busy = drop_full(sites, busy, count);
    }
  }

  /// Lets each busy octant go on to its next cube. Returns the lanes of those that have one.
  Lanes next_cubes(Sites& sites, Lanes busy, int count) {
    for (int i = 0; i < count; ++i) {
      if (!(busy & lanes_of(i)).any()) continue;
      const int cube = walks_[i].next(vm_, sites.walk);
      if (cube < 0) {
        busy = busy & ~lanes_of(i);
        continue;
      }
      const std::int32_t first_word = cube * samples_.words;
      first_words_.fill(static_cast<std::size_t>(i), &first_word, 1);
      if constexpr (Vm::kCounted) ++sink_.counts[kCubesMerged];
    }
    return busy;
  }

  /// Octants whose image is full are finished.
  Lanes drop_full(Sites& sites, Lanes busy, int count) {
    using namespace isa;
    if (!busy.any()) return busy;
    const Lanes full = cmp_eq(sites.checking.on(busy), words_[0], -1);
    for (int i = 0; i < count; ++i) {
      const Lanes own = busy & lanes_of(i);
      if (own.any() && all(sites.checking.on(own), full)) busy = busy & ~own;
    }
    return busy;
  }

  Vm& vm_;
  const SkySamples& samples_;
  Memory<const std::int32_t> images_;
  int octants_at_a_time_;
  ImageSink<Vm::kCounted>& sink_;
  OpenOctants open_{vm_.checks()};
  ImageMemory rendered_{vm_.checks()};
  ScalarSums sums_{vm_.checks()};
  CubeWalk<Vm> walks_[kMostOctants];
  /// Of the cubes that octants are at, where their images begin.
  Buffer<std::int32_t> first_words_{kMostOctants, "images to merge", vm_.checks()};
  Int words_[kMostWords];  ///< The images that are being rendered, W words a vector.
};

}  // namespace lanescope
