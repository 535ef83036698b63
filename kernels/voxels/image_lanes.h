// SPDX-License-Identifier: MIT
// What programs share that render one octant at a time: its image stands in memory, and the scalar
// unit adds up the harmonics.
#pragma once

#include "kernels/voxels/stages.h"

namespace lanescope {

/// The rows of one octant, of one level.
struct RowsOfOctant {
  RowsOfOctant(const BrickMemory& brick, const Level& level, int probe, int octant)
      : rows(brick.rows()),
        steps(memory_of(*level.steps, "steps to rows")
                  .part(static_cast<std::size_t>(octant) * kOctantRows, kOctantRows)),
        row_bits(memory_of(*level.row_bits, "bits of rows")),
        row(level.row[static_cast<std::size_t>(probe)] +
            level.start[static_cast<std::size_t>(octant)]),
        bit(level.bit[static_cast<std::size_t>(probe)]) {
    if (octant & 1) bit = level.turned_bit - bit;
  }

  /// The filled cubes of rows first, first + 1 ..., a row a lane.
  template <class Vm, class On>
  LANESCOPE_INLINE typename Vm::Int cubes(On& on, int first) const {
    using namespace isa;
    const auto place = add(on, load(on, steps, first), row);
    return bit_and(on, shr(on, gather(on, rows, place), bit), load(on, row_bits, first));
  }

  Memory<const std::int32_t> rows, steps, row_bits;
  std::int32_t row, bit;
};

/// The rows of one octant, the nearest level first.
class OctantLevels {
 public:
  OctantLevels(const BrickMemory& brick, int probe, int octant)
      : brick_(brick), probe_(probe), octant_(octant) {}

  /// Calls `merge(rows, first)` for each W rows, until it returns that the image is full. Returns
  /// whether it is.
  template <class Merge>
  LANESCOPE_INLINE bool merge_all(int width, const Merge& merge) const {
    for (const Level& level : brick_.levels) {
      const RowsOfOctant rows(brick_, level, probe_, octant_);
      for (int first = 0; first < kOctantRows; first += width)
        if (merge(rows, first)) return true;
    }
    return false;
  }

 private:
  const BrickMemory& brick_;
  int probe_, octant_;
};

/// An image in memory, with as many words as are read at a time beyond its end.
struct ImageMemory {
  explicit ImageMemory(bool checked) : words(kMostWords + 64, "image", checked) {}
  Buffer<std::int32_t> words;
};

using ScalarHarmonics = std::array<std::int32_t, kHarmonics>;

/// *Project* of one image, a lane a sample: those that see the sky add what they are worth.
template <class Vm>
ScalarHarmonics selected_worths(Vm& vm, const SkySamples& samples, ImageMemory& image) {
  using namespace isa;
  auto testing = vm.site(kProject);
  auto adding = vm.site(kProject);
  ScalarHarmonics sums{};
  for (int first = 0; first < samples.count(); first += vm.width()) {
    typename Vm::Lanes sky;
    {
      auto on = testing.on(vm.first_n(samples.count() - first));
      const auto sample = add(on, lane_index(on), first);
      const auto word = gather(on, image.words.memory(), shr(on, sample, 5));
      sky = cmp_eq(on, bit_and(on, shr(on, word, bit_and(on, sample, kWordBits - 1)), 1), 0);
    }
    auto on = adding.on(sky);
    host::unroll<kHarmonics>([&](auto h) LANESCOPE_INLINE_LAMBDA {
      const auto& worth = samples.worth[h];
      sums[h] += hadd(on, load(on, read_only(worth.data(), worth.size(), "worth"), first));
    });
  }
  return sums;
}

/// *Project* by counting, a lane a word.
template <class Vm>
ScalarHarmonics counted_samples(Vm& vm, const SkySamples& samples, ImageMemory& image) {
  using namespace isa;
  auto counting = vm.site(kProject);
  auto adding = vm.site(kProject);
  ScalarHarmonics sums;
  sums.fill(kCountedWords * kWordBits);
  for (int first = 0; first < samples.words; first += vm.width()) {
    const int lanes = std::min(vm.width(), samples.words - first);
    typename Vm::Int occluded;
    {
      auto on = counting.on(vm.first_n(lanes));
      occluded = popcount(on, load(on, image.words.memory(), first));
    }
    for (int h = first / kCountedWords; h * kCountedWords < first + lanes; ++h) {
      const int begin = std::max(0, h * kCountedWords - first);
      const int end = std::min(lanes, (h + 1) * kCountedWords - first);
      auto on = adding.on(Vm::Lanes::from_bits(low_bits(end) & ~low_bits(begin)));
      sums[static_cast<std::size_t>(h)] -= hadd(on, occluded);
    }
  }
  return sums;
}

/// The sums of a brick's probes, of which the scalar unit keeps one at a time.
class ScalarSums {
 public:
  explicit ScalarSums(bool checked) : sums_(checked) {}

  HarmonicSums& memory() { return sums_; }
  void clear(int probes) { all_.assign(static_cast<std::size_t>(probes), {}); }
  void add(int probe, int octant, const ScalarHarmonics& seen) {
    for (int h = 0; h < kHarmonics; ++h) {
      const auto i = static_cast<std::size_t>(h);
      all_[static_cast<std::size_t>(probe)][i] += is_negative(h, octant) ? -seen[i] : seen[i];
    }
  }
  /// Stores all where vector instructions find them.
  void store() {
    for (std::size_t h = 0; h < kHarmonics; ++h)
      for (std::size_t probe = 0; probe < all_.size(); ++probe)
        sums_.sums.fill(h * HarmonicSums::kMost + probe, &all_[probe][h], 1);
  }

 private:
  HarmonicSums sums_;
  std::vector<ScalarHarmonics> all_;
};

/// A program that renders one octant at a time. Renderer has
///   void render(const OctantLevels&, ImageMemory&);
template <class Vm, class Renderer>
void render_each_octant(Vm& vm, const BrickMemory& brick, const SkySamples& samples,
                        OpenOctants& open, ImageMemory& image, ScalarSums& sums,
                        ImageSink<Vm::kCounted>& sink, Memory<float> harmonics,
                        Renderer& renderer) {
  list_open_octants(vm, brick, open, sink.counts);
  sums.clear(brick.size());
  for (int i = 0; i < open.size; ++i) {
    const int probe = open.probe(i), octant = open.octant(i);
    vm.begin_batch();
    renderer.render(OctantLevels(brick, probe, octant), image);
    sink.take(brick.brick->first_probe + static_cast<std::uint64_t>(probe), octant,
              image.words.data(), samples.words, 1);
    sums.add(probe, octant,
             samples.by_counting ? counted_samples(vm, samples, image)
                                 : selected_worths(vm, samples, image));
  }
  sums.store();
  finish_probes(vm, samples, sums.memory(), brick.size(), harmonics);
}

}  // namespace lanescope
