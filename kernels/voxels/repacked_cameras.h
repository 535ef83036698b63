// SPDX-License-Identifier: MIT
// Lanes are octants of corners, with REPACK's idea (Luong, 3.2.2): a lane whose cube is empty does
// not wait, but goes on to its next filled one, and a lane that has finished its octant takes the
// next octant. So every lane is at a cube of its own, whose image it has to fetch, and its own
// image is in memory.
#pragma once

#include <cmath>
#include <optional>
#include <tuple>

#include "kernels/voxels/camera_lanes.h"

namespace lanescope {

template <class Vm>
class RepackedCameras {
 public:
  static constexpr std::size_t kStageCount = kProbeStages.size();

  RepackedCameras(Vm& vm, const ProbeProgram& program, ImageSink<Vm::kCounted>& sink)
      : vm_(vm),
        samples_(program.samples),
        parts_(read_only(reinterpret_cast<const std::int32_t*>(program.cubes.parts.data()),
                         2 * program.cubes.parts.size(), "parts of images")),
        parts_of_cube_(words_of(program.cubes.parts_of_cube, "parts of cubes")),
        merge_threshold_(program.options.merge_threshold),
        sink_(sink) {}

  void render(const BrickMemory& brick, Memory<float> harmonics) {
    list_open_octants(vm_, brick, open_, sink_.counts);
    hold(open_.size);
    Sites sites(vm_);
    clear_memory(sites.clearing, images_->memory(), open_.size * samples_.words);
    for (const Level& level : brick.levels) render_octants(sites, brick, level);
    for (int i = 0; i < open_.size; ++i)
      sink_.take(brick.brick->first_probe + static_cast<std::uint64_t>(open_.probe(i)),
                 open_.octant(i), images_->data() + i * samples_.words, samples_.words, 1);
    project(sites, brick.size());
    finish_probes(vm_, samples_, sums_, brick.size(), harmonics);
  }

 private:
  using Int = typename Vm::Int;
  using Lanes = typename Vm::Lanes;

  /// Merges of a vector before it is looked at again which images are full.
  static constexpr int kMergesBetweenChecks = 16;

  struct Sites {
    explicit Sites(Vm& vm)
        : loading(vm.site(kScan)),
          turning(vm.site(kScan)),
          seeking(vm.site(kScan)),
          clearing(vm.site(kMerge)),
          choosing(vm.site(kMerge)),
          merging(vm.site(kMerge)),
          checking(vm.site(kMerge)),
          fetching(vm.site(kProject)),
          zeroing(vm.site(kProject)),
          projecting(vm.site(kProject)),
          summing(vm.site(kProject)) {}
    typename Vm::Site loading, turning, seeking, clearing, choosing, merging, checking, fetching,
        zeroing, projecting, summing;
  };

  /// What each lane is at work on.
  struct AtWork {
    Lanes busy = Lanes::none();
    Lanes found = Lanes::none();  ///< Those that have a filled cube.
    Lanes last = Lanes::none();   ///< Those that are at their last row.
    Int image{};                  ///< Where its image begins.
    Int row{}, bit{};             ///< Of the first cubes of the octant.
    Int next{};                   ///< The next step, in octant_row_steps().
    Int cubes{}, first_cube{};    ///< Those left of the row, and the number of its first one.
  };

  void hold(int octants) {
    if (octants <= held_ && images_) return;
    held_ = std::max(1, octants);
    images_.emplace(static_cast<std::size_t>(held_ * kMostWords), "images", vm_.checks());
  }

  void clear_memory(typename Vm::Site& site, Memory<std::int32_t> memory, int size) {
    for (int first = 0; first < size; first += vm_.width()) {
      auto on = site.on(vm_.first_n(size - first));
      isa::store(on, memory, first, isa::broadcast(on, 0));
    }
  }

  void render_octants(Sites& sites, const BrickMemory& brick, const Level& level) {
    AtWork lanes;
    int taken = 0, unchecked = 0;
    while (true) {
      if (taken < open_.size) take_octants(sites, level, lanes, taken);
      if (!lanes.busy.any()) return;
      if (is_worth_merging(lanes)) {
        merge(sites, lanes);
        if (++unchecked == kMergesBetweenChecks) {
          drop_full(sites, lanes);
          unchecked = 0;
        }
      } else {
        seek(sites, brick, level, lanes);
      }
      lanes.busy = lanes.busy & ~(lanes.last & ~lanes.found);
    }
  }

  /// Whether enough lanes have a cube, or no other can get one.
  bool is_worth_merging(const AtWork& lanes) const {
    const Lanes can_seek = lanes.busy & ~lanes.found;
    const int found = lanes.found.count();
    return !can_seek.any() ||
           (found > 0 &&
            static_cast<float>(found) >= merge_threshold_ * static_cast<float>(lanes.busy.count()));
  }

  /// Free lanes take the next octants of the list.
  void take_octants(Sites& sites, const Level& level, AtWork& lanes, int& taken) {
    using namespace isa;
    const Lanes free = vm_.all() & ~lanes.busy;
    if (!free.any()) return;
    vm_.begin_batch();
    Lanes loaded, falling;
    {
      auto on = sites.loading.on(free);
      const auto place = add(on, prefix_sum(on, free), taken - 1);
      loaded = cmp_lt(on, place, open_.size);
      const auto item = gather(sites.turning.on(loaded), open_.items.memory(), place);
      auto into = sites.turning.on(loaded);
      const auto probe = shr(into, item, 3);
      const auto octant = bit_and(into, item, kOctants - 1);
      const auto start = gather(
          into, read_only(level.start.data(), level.start.size(), "starts of octants"), octant);
      const auto row = gather(into, memory_of(level.row, "rows of probes"), probe);
      lanes.row = move(into, add(into, row, start), lanes.row);
      lanes.bit = gather(into, memory_of(level.bit, "bits of probes"), probe, lanes.bit);
      lanes.next = move(into, mul(into, octant, kOctantRows), lanes.next);
      lanes.image = move(into, mul(into, place, samples_.words), lanes.image);
      falling = cmp_ne(into, bit_and(into, octant, 1), 0);
    }
    auto on = sites.turning.on(falling);
    lanes.bit = move(on, sub(on, level.turned_bit, lanes.bit), lanes.bit);
    taken += loaded.count();
    lanes.busy = lanes.busy | loaded;
    lanes.last = lanes.last & ~loaded;
  }

  /// Lanes without a cube go on to their next row.
  LANESCOPE_INLINE void seek(Sites& sites, const BrickMemory& brick, const Level& level,
                             AtWork& lanes) {
    using namespace isa;
    const Lanes seeking = lanes.busy & ~lanes.found;
    auto on = sites.seeking.on(seeking);
    const auto row =
        add(on, lanes.row, gather(on, memory_of(*level.steps, "steps to rows"), lanes.next));
    const auto number = bit_and(on, lanes.next, kOctantRows - 1);
    const auto row_bits = gather(on, memory_of(*level.row_bits, "bits of rows"), number);
    lanes.cubes =
        move(on, cubes_of_row<Vm>(on, brick.rows(), row, lanes.bit, row_bits), lanes.cubes);
    lanes.first_cube = move(on, mul(on, number, kReach), lanes.first_cube);
    lanes.next = move(on, add(on, lanes.next, 1), lanes.next);
    lanes.found = lanes.found | cmp_ne(on, lanes.cubes, 0);
    lanes.last = lanes.last | cmp_eq(on, number, kOctantRows - 1);
  }

  /// Each lane that has a cube merges the nearest one.
  LANESCOPE_INLINE void merge(Sites& sites, AtWork& lanes) {
    using namespace isa;
    const Lanes found = lanes.found;
    Int part, count;
    std::int32_t most;
    {
      auto on = sites.choosing.on(found);
      const auto cube = add(on, lanes.first_cube, ctz(on, lanes.cubes));
      lanes.cubes = move(on, bit_and(on, lanes.cubes, sub(on, lanes.cubes, 1)), lanes.cubes);
      std::tie(part, count) = gather_pair(on, parts_of_cube_, cube);
      most = hmax(on, count);
      lanes.found = cmp_ne(on, lanes.cubes, 0);
    }
    for (std::int32_t i = 0; i < most; ++i) {
      Lanes left;
      {
        auto on = sites.choosing.on(found);
        left = cmp_gt(on, count, i);
      }
      auto on = sites.merging.on(left);
      const auto [word, bits] = gather_pair(on, parts_, add(on, part, i));
      scatter_or(on, images_->memory(), add(on, lanes.image, word), bits);
    }
    if constexpr (Vm::kCounted)
      sink_.counts[kCubesMerged] += static_cast<std::uint64_t>(found.count());
  }

  /// Lanes whose image is full are finished.
  void drop_full(Sites& sites, AtWork& lanes) {
    Int image[kMostWords];
    fetch_images(sites.checking, lanes.busy, lanes.image, image);
    const Lanes full = full_images<Vm>(sites.checking, lanes.busy, image, samples_.words);
    lanes.busy = lanes.busy & ~full;
    lanes.found = lanes.found & ~full;
  }

  void fetch_images(typename Vm::Site& site, Lanes active, const Int& place, Int* image) {
    using namespace isa;
    for (int w = 0; w < samples_.words; ++w) {
      const auto i = static_cast<std::size_t>(w);
      auto on = site.on(active);
      image[w] = gather(on, images_->memory().part(i, images_size() - i), place);
    }
  }

  /// *Project* of all images, W at a time.
  void project(Sites& sites, int probes) {
    using namespace isa;
    for (int h = 0; h < kHarmonics; ++h) clear_memory(sites.zeroing, sums_.of(h), probes);
    for (int first = 0; first < open_.size; first += vm_.width()) {
      const Lanes valid = vm_.first_n(open_.size - first);
      Int place, item;
      {
        auto on = sites.summing.on(valid);
        place = mul(on, add(on, lane_index(on), first), samples_.words);
        item = load(on, open_.items.memory(), first);
      }
      Int image[kMostWords];
      fetch_images(sites.fetching, valid, place, image);
      const HarmonicVectors<Vm> seen = seen_by<Vm>(sites.projecting, valid, samples_, image);
      add_up(sites.summing, valid, item, seen);
    }
  }

  /// Adds what each lane's octant sees to the sums of its probe.
  void add_up(typename Vm::Site& site, Lanes valid, const Int& item,
              const HarmonicVectors<Vm>& seen) {
    using namespace isa;
    auto on = site.on(valid);
    const auto probe = shr(on, item, 3);
    scatter_add(on, sums_.of(0), probe, seen.of[0]);
    host::unroll<kHarmonics - 1>([&](auto axis) LANESCOPE_INLINE_LAMBDA {
      const auto falls = cmp_ne(on, bit_and(on, item, 1 << axis), 0);
      const auto& sum = seen.of[axis + 1];
      scatter_add(on, sums_.of(axis + 1), probe, select(on, falls, sub(on, 0, sum), sum));
    });
  }

  std::size_t images_size() const { return static_cast<std::size_t>(held_ * kMostWords); }

  Vm& vm_;
  const SkySamples& samples_;
  Memory<const std::int32_t> parts_;          ///< Pairs of word and bits.
  Memory<const std::int32_t> parts_of_cube_;  ///< Pairs of first part and count.
  float merge_threshold_;                     ///< Share of the busy lanes.
  ImageSink<Vm::kCounted>& sink_;
  OpenOctants open_{vm_.checks()};
  HarmonicSums sums_{vm_.checks()};
  std::optional<Buffer<std::int32_t>> images_;  ///< Of the octants in open_.
  int held_ = 0;                                ///< Octants that images_ has room for.
};

}  // namespace lanescope
