// SPDX-License-Identifier: MIT
// A lane is a filled cube: the filled cubes of an octant are compacted into a queue, and W images
// at a time are merged by reduction, word by word.
#pragma once

#include "kernels/voxels/image_lanes.h"

namespace lanescope {

template <class Vm>
class AcrossCubes {
 public:
  static constexpr std::size_t kStageCount = kProbeStages.size();

  AcrossCubes(Vm& vm, const ProbeProgram& program, ImageSink<Vm::kCounted>& sink)
      : vm_(vm),
        samples_(program.samples),
        images_(words_of(program.cubes.images, "images of cubes")),
        sink_(sink) {}

  void render(const BrickMemory& brick, Memory<float> harmonics) {
    render_each_octant(vm_, brick, samples_, open_, rendered_, sums_, sink_, harmonics, *this);
  }

  int octants_at_a_time() const { return 1; }

  /// Renders an octant of the list.
  void render(const BrickMemory& brick, const OpenOctants& open, int item, int /*count*/,
              ImageMemory& rendered) {
    Sites sites(vm_);
    words_.fill(0);
    queued_ = 0;
    const bool full = merge_full_vectors(sites, brick, open.probe(item), open.octant(item));
    if (!full && queued_ > 0) merge(sites, queued_);
    rendered.words.fill(0, words_.data(), words_.size());
  }

 private:
  using Int = typename Vm::Int;
  using Lanes = typename Vm::Lanes;

  struct Sites {
    explicit Sites(Vm& vm)
        : scanning(vm.site(kScan)),
          finding(vm.site(kScan)),
          queueing(vm.site(kScan)),
          merging(vm.site(kMerge)) {}
    typename Vm::Site scanning, finding, queueing, merging;
  };

  /// Merges cubes as long as they fill a vector. Returns whether the image is full.
  bool merge_full_vectors(Sites& sites, const BrickMemory& brick, int probe, int octant) {
    for (const Level& level : brick.levels) {
      const RowsOfOctant rows(brick, level, probe, octant);
      for (int first = 0; first < kOctantRows; first += vm_.width())
        if (queue_rows(sites, rows, first)) return true;
    }
    return false;
  }

  /// Queues the filled cubes of W rows, and merges what fills a vector. Returns whether the image
  /// is full.
  bool queue_rows(Sites& sites, const RowsOfOctant& octant, int first) {
    using namespace isa;
    const Lanes rows = vm_.first_n(kOctantRows - first);
    Int cubes, row;
    std::int32_t anywhere;
    {
      auto on = sites.scanning.on(rows);
      cubes = octant.template cubes<Vm>(on, first);
      row = mul(on, add(on, lane_index(on), first), kReach);
      anywhere = hor(on, cubes);
    }
    for (auto bits = static_cast<std::uint32_t>(anywhere); bits != 0; bits &= bits - 1) {
      queue_cubes(sites, rows, cubes, row, std::countr_zero(bits));
      if (queued_ < vm_.width()) continue;
      merge(sites, vm_.width());
      if (is_full()) return true;
    }
    return false;
  }

  /// Queues the i-th cubes of rows where they are filled.
  LANESCOPE_INLINE void queue_cubes(Sites& sites, Lanes rows, const Int& cubes, const Int& row,
                                    int i) {
    using namespace isa;
    Int cube;
    int found;
    {
      auto on = sites.finding.on(rows);
      const auto filled = cmp_ne(on, bit_and(on, cubes, 1 << i), 0);
      cube = compress(on, filled, add(on, row, i));
      found = count(on, filled);
    }
    store(sites.queueing.on(vm_.first_n(found)), queue_.memory(), queued_, cube);
    queued_ += found;
  }

  /// Merges the last `count` cubes of the queue.
  LANESCOPE_INLINE void merge(Sites& sites, int count) {
    using namespace isa;
    queued_ -= count;
    auto on = sites.merging.on(vm_.first_n(count));
    const auto image = mul(on, load(on, queue_.memory(), queued_), samples_.words);
    for (int w = 0; w < samples_.words; ++w) {
      const auto i = static_cast<std::size_t>(w);
      words_[i] |= hor(on, gather(on, images_.part(i, images_.size - i), image));
    }
    if constexpr (Vm::kCounted) sink_.counts[kCubesMerged] += static_cast<std::uint64_t>(count);
  }

  /// The words are scalars here.
  bool is_full() const {
    return std::all_of(words_.begin(), words_.begin() + samples_.words,
                       [](std::int32_t word) { return word == -1; });
  }

  Vm& vm_;
  const SkySamples& samples_;
  Memory<const std::int32_t> images_;
  ImageSink<Vm::kCounted>& sink_;
  OpenOctants open_{vm_.checks()};
  ImageMemory rendered_{vm_.checks()};
  ScalarSums sums_{vm_.checks()};
  Buffer<std::int32_t> queue_{2 * static_cast<std::size_t>(vm_.width()), "filled cubes",
                              vm_.checks()};
  int queued_ = 0;  ///< Entries of queue_.
  std::array<std::int32_t, kMostWords> words_{};
};

}  // namespace lanescope
