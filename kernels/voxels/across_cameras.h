// SPDX-License-Identifier: MIT
// A lane is a corner to render from. All lanes walk the same cubes, relative to their corners, and
// are masked where theirs is empty: the image to merge is the same for all of them, so it is a
// constant.
#pragma once

#include "kernels/voxels/camera_lanes.h"

namespace lanescope {

template <class Vm>
class AcrossCameras {
 public:
  static constexpr std::size_t kStageCount = kProbeStages.size();

  AcrossCameras(Vm& vm, const ProbeProgram& program, ImageSink<Vm::kCounted>& sink)
      : vm_(vm), samples_(program.samples), cubes_(program.cubes), sink_(sink) {}

  void render(const BrickMemory& brick, Memory<float> harmonics) {
    Sites sites(vm_);
    for (int first = 0; first < brick.size(); first += vm_.width()) {
      vm_.begin_batch();
      const Lanes valid = vm_.first_n(brick.size() - first);
      HarmonicVectors<Vm> sums;
      clear<Vm>(sites.summing, valid, sums);
      for (int octant = 0; octant < kOctants; ++octant) {
        const Lanes open = render_octant(sites, brick, valid, first, octant);
        if constexpr (Vm::kCounted)
          sink_.counts[kOctantsBlocked] += static_cast<std::uint64_t>(valid.count() - open.count());
        if (!open.any()) continue;
        take_images<Vm>(sink_, open, image_, samples_.words, [&](int lane) {
          return std::pair(brick.brick->first_probe + static_cast<std::uint64_t>(first + lane),
                           octant);
        });
        add_octant(sites, open, octant, sums);
      }
      auto on = sites.finishing.on(valid);
      store_harmonics(on, samples_, harmonics, first,
                      [&](auto h) LANESCOPE_INLINE_LAMBDA { return sums.of[h]; });
    }
  }

 private:
  using Int = typename Vm::Int;
  using Lanes = typename Vm::Lanes;

  /// Rows after which lanes whose image is full are told from the others.
  static constexpr int kCheckedRows[] = {4, 8, 16, 32, 64, 128, kOctantRows};

  struct Sites {
    explicit Sites(Vm& vm)
        : scanning(vm.site(kScan)),
          seeing(vm.site(kScan)),
          finding(vm.site(kScan)),
          clearing(vm.site(kMerge)),
          merging(vm.site(kMerge)),
          checking(vm.site(kMerge)),
          summing(vm.site(kProject)),
          projecting(vm.site(kProject)),
          finishing(vm.site(kProject)) {}
    typename Vm::Site scanning, seeing, finding, clearing, merging, checking, summing, projecting,
        finishing;
  };

  /// Renders an octant of each lane's corner. Returns the lanes that are not blocked.
  Lanes render_octant(Sites& sites, const BrickMemory& brick, Lanes valid, int first, int octant) {
    using namespace isa;
    Lanes open;
    {
      auto on = sites.scanning.on(valid);
      const FirstCubes<Vm> cubes = first_cubes<Vm>(on, brick.levels[0], first, octant);
      open = cmp_eq(on, cubes_of_row<Vm>(on, brick.rows(), cubes.row, cubes.bit, 1), 0);
    }
    if (!open.any()) return open;
    clear_images<Vm>(sites.clearing, open, image_, samples_.words);
    Lanes seeing = open;
    for (const Level& level : brick.levels) {
      seeing = render_level(sites, brick, level, seeing, first, octant);
      if (!seeing.any()) break;
    }
    return open;
  }

  /// Merges what one level has. Returns the lanes whose image is not full.
  Lanes render_level(Sites& sites, const BrickMemory& brick, const Level& level, Lanes seeing,
                     int first, int octant) {
    FirstCubes<Vm> cubes;
    {
      auto on = sites.scanning.on(seeing);
      cubes = first_cubes<Vm>(on, level, first, octant);
    }
    const std::int32_t* const steps = level.steps->data() + octant * kOctantRows;
    int r = 0;
    for (const int end : kCheckedRows) {
      for (; r < end; ++r)
        merge_row(sites, brick, seeing, cubes, steps[r],
                  (*level.row_bits)[static_cast<std::size_t>(r)], r);
      if (end == kOctantRows && &level == &brick.levels.back()) break;
      seeing = seeing & ~full_images<Vm>(sites.checking, seeing, image_, samples_.words);
      if (!seeing.any()) break;
    }
    return seeing;
  }

  /// Merges the filled cubes of a row.
  LANESCOPE_INLINE void merge_row(Sites& sites, const BrickMemory& brick, Lanes seeing,
                                  const FirstCubes<Vm>& first, std::int32_t step,
                                  std::int32_t row_bits, int r) {
    using namespace isa;
    Int cubes;
    std::int32_t anywhere;
    {
      auto on = sites.seeing.on(seeing);
      cubes = cubes_of_row<Vm>(on, brick.rows(), add(on, first.row, step), first.bit, row_bits);
      anywhere = hor(on, cubes);
    }
    for_each_bit(anywhere, [&](int i) LANESCOPE_INLINE_LAMBDA {
      Lanes filled;
      {
        auto on = sites.finding.on(seeing);
        filled = cmp_ne(on, bit_and(on, cubes, 1 << i), 0);
      }
      for (const CubeImages::Part& part : cubes_.parts_of(kReach * r + i)) {
        auto on = sites.merging.on(filled);
        Int& word = image_[part.word];
        word = or_into(on, word, static_cast<std::int32_t>(part.bits), word);
      }
      if constexpr (Vm::kCounted)
        sink_.counts[kCubesMerged] += static_cast<std::uint64_t>(filled.count());
    });
  }

  /// *Project* of an octant: adds what its lanes see to their sums.
  void add_octant(Sites& sites, Lanes open, int octant, HarmonicVectors<Vm>& sums) {
    using namespace isa;
    const HarmonicVectors<Vm> seen = seen_by<Vm>(sites.projecting, open, samples_, image_);
    auto on = sites.summing.on(open);
    host::unroll<kHarmonics>([&](auto h) LANESCOPE_INLINE_LAMBDA {
      Int& sum = sums.of[h];
      sum = move(on, is_negative(h, octant) ? sub(on, sum, seen.of[h]) : add(on, sum, seen.of[h]),
                 sum);
    });
  }

  Vm& vm_;
  const SkySamples& samples_;
  const CubeImages& cubes_;
  ImageSink<Vm::kCounted>& sink_;
  Int image_[kMostWords];
};

}  // namespace lanescope
