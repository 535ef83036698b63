// SPDX-License-Identifier: MIT
// The article's form: a lane is a word of the image. Rows of cubes are looked at W at a time; then
// the scalar unit walks the filled cubes of each, and the image of each is merged by one load and
// one `or`.
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
        sink_(sink) {}

  void render(const BrickMemory& brick, Memory<float> harmonics) {
    render_each_octant(vm_, brick, samples_, open_, image_, sums_, sink_, harmonics, *this);
  }

  /// Renders an octant that is open.
  void render(const OctantLevels& octant, ImageMemory& image) {
    using namespace isa;
    Sites sites(vm_);
    for_each_part(sites.clearing, [&](auto& on, int part, int)
                                      LANESCOPE_INLINE_LAMBDA { words_[part] = broadcast(on, 0); });
    unchecked_ = 0;
    octant.merge_all(vm_.width(), [&](const RowsOfOctant& rows, int first) {
      return merge_rows(sites, rows, first);
    });
    for_each_part(sites.storing, [&](auto& on, int part, int first) LANESCOPE_INLINE_LAMBDA {
      store(on, image.words.memory(), first, words_[part]);
    });
  }

 private:
  using Int = typename Vm::Int;
  using Lanes = typename Vm::Lanes;

  /// Cubes that are merged before it is looked at again whether the image is full.
  static constexpr int kCubesBetweenChecks = 12;

  struct Sites {
    explicit Sites(Vm& vm)
        : scanning(vm.site(kScan)),
          taking(vm.site(kScan)),
          clearing(vm.site(kMerge)),
          merging(vm.site(kMerge)),
          checking(vm.site(kMerge)),
          storing(vm.site(kMerge)) {}
    typename Vm::Site scanning, taking, clearing, merging, checking, storing;
  };

  /// Calls `issue(on, part, first word)` for each vector that holds a part of the image.
  template <class Issue>
  LANESCOPE_INLINE void for_each_part(typename Vm::Site& site, const Issue& issue) {
    for (int part = 0, first = 0; first < samples_.words; ++part, first += vm_.width()) {
      auto on = site.on(vm_.first_n(samples_.words - first));
      issue(on, part, first);
    }
  }

  /// Merges the filled cubes of W rows. Returns whether the image is full.
  bool merge_rows(Sites& sites, const RowsOfOctant& octant, int first) {
    using namespace isa;
    Int cubes;
    Lanes filled;
    {
      auto on = sites.scanning.on(vm_.first_n(kOctantRows - first));
      cubes = octant.template cubes<Vm>(on, first);
      filled = cmp_ne(on, cubes, 0);
    }
    for (std::uint64_t left = filled.bits(); left != 0; left &= left - 1) {
      const int lane = std::countr_zero(left);
      const std::int32_t row = hor(sites.taking.on(Lanes::from_bits(left & -left)), cubes);
      for_each_bit(
          row, [&](int i) LANESCOPE_INLINE_LAMBDA { merge(sites, kReach * (first + lane) + i); });
      if (unchecked_ >= kCubesBetweenChecks && is_full(sites)) return true;
    }
    return false;
  }

  LANESCOPE_INLINE void merge(Sites& sites, int cube) {
    using namespace isa;
    const std::int64_t image = std::int64_t{cube} * samples_.words;
    for_each_part(sites.merging, [&](auto& on, int part, int first) LANESCOPE_INLINE_LAMBDA {
      words_[part] = bit_or(on, words_[part], load(on, images_, image + first));
    });
    ++unchecked_;
    if constexpr (Vm::kCounted) ++sink_.counts[kCubesMerged];
  }

  bool is_full(Sites& sites) {
    using namespace isa;
    unchecked_ = 0;
    bool full = true;
    for_each_part(sites.checking, [&](auto& on, int part, int) LANESCOPE_INLINE_LAMBDA {
      full = full && all(on, cmp_eq(on, words_[part], -1));
    });
    return full;
  }

  Vm& vm_;
  const SkySamples& samples_;
  Memory<const std::int32_t> images_;
  ImageSink<Vm::kCounted>& sink_;
  OpenOctants open_{vm_.checks()};
  ImageMemory image_{vm_.checks()};
  ScalarSums sums_{vm_.checks()};
  Int words_[kMostWords];  ///< The image that is being rendered, W words a vector.
  int unchecked_ = 0;      ///< Cubes merged since the image was seen not to be full.
};

}  // namespace lanescope
