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

/// The filled cubes of one octant, the nearest rows first, one after the other: rows are looked at
/// W at a time, and the scalar unit walks the cubes of each.
template <class Vm>
class CubeWalk {
 public:
  /// Where a walk issues its instructions.
  struct Sites {
    explicit Sites(Vm& vm) : scanning(vm.site(kScan)), taking(vm.site(kScan)) {}
    typename Vm::Site scanning, taking;
  };

  CubeWalk() = default;
  CubeWalk(const BrickMemory& brick, int probe, int octant)
      : brick_(&brick), probe_(probe), octant_(octant) {}

  /// The number of the next filled cube, or -1 if there is none.
  LANESCOPE_INLINE int next(Vm& vm, Sites& sites) {
    while (row_ == 0)
      if (rows_left_ != 0)
        take_row(sites);
      else if (!scan_rows(vm, sites))
        return -1;
    const int i = std::countr_zero(row_);
    row_ &= row_ - 1;
    return kReach * (first_ + lane_) + i;
  }

 private:
  void take_row(Sites& sites) {
    lane_ = std::countr_zero(rows_left_);
    auto on = sites.taking.on(Vm::Lanes::from_bits(rows_left_ & -rows_left_));
    row_ = static_cast<std::uint32_t>(isa::hor(on, cubes_));
    rows_left_ &= rows_left_ - 1;
  }

  /// Looks at the next W rows. Returns whether there are any.
  bool scan_rows(Vm& vm, Sites& sites) {
    first_ += vm.width();
    if (first_ >= kOctantRows) {
      ++level_;
      first_ = 0;
    }
    if (level_ == brick_->levels.size()) return false;
    auto on = sites.scanning.on(vm.first_n(kOctantRows - first_));
    cubes_ = RowsOfOctant(*brick_, brick_->levels[level_], probe_, octant_)
                 .template cubes<Vm>(on, first_);
    rows_left_ = isa::cmp_ne(on, cubes_, 0).bits();
    return true;
  }

  const BrickMemory* brick_ = nullptr;
  int probe_ = 0, octant_ = 0;
  std::size_t level_ = std::size_t(-1);  ///< Before the first.
  int first_ = kOctantRows;              ///< The first of the rows looked at.
  typename Vm::Int cubes_{};             ///< Of these rows.
  std::uint64_t rows_left_ = 0;          ///< Those with cubes, of which none was taken.
  int lane_ = 0;                         ///< The row whose cubes are walked,
  std::uint32_t row_ = 0;                ///< and those that are left of it.
};

/// Images in memory, one after the other; with as many words as are read at a time beyond them.
struct ImageMemory {
  explicit ImageMemory(bool checked) : words(kMostWords + 2 * 64, "images", checked) {}
  /// From the image of the n-th octant on.
  Memory<std::int32_t> image(int n, const SkySamples& samples) {
    const auto first = static_cast<std::size_t>(n * samples.words);
    return words.memory().part(first, words.memory().size - first);
  }
  Buffer<std::int32_t> words;
};

using ScalarHarmonics = std::array<std::int32_t, kHarmonics>;

/// *Project* of one image, a lane a sample: those that see the sky add what they are worth.
template <class Vm>
ScalarHarmonics selected_worths(Vm& vm, const SkySamples& samples, Memory<std::int32_t> image) {
  using namespace isa;
  auto testing = vm.site(kProject);
  auto adding = vm.site(kProject);
  ScalarHarmonics sums{};
  for (int first = 0; first < samples.count(); first += vm.width()) {
    typename Vm::Lanes sky;
    {
      auto on = testing.on(vm.first_n(samples.count() - first));
      const auto sample = add(on, lane_index(on), first);
      const auto word = gather(on, image, shr(on, sample, 5));
      sky = cmp_eq(on, bit_and(on, shr(on, word, bit_and(on, sample, kWordBits - 1)), 1), 0);
    }
    auto on = adding.on(sky);
    host::unroll<kHarmonics>([&](auto h) LANESCOPE_INLINE_LAMBDA {
      const auto& worth = samples.worth[h];
      // Where no sample sees the sky, nothing is added.
      sums[h] += hadd(on.allowing(Check::kNoLane),
                      load(on, read_only(worth.data(), worth.size(), "worth"), first));
    });
  }
  return sums;
}

/// *Project* by counting, a lane a word.
template <class Vm>
ScalarHarmonics counted_samples(Vm& vm, const SkySamples& samples, Memory<std::int32_t> image) {
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
      occluded = popcount(on, load(on, image, first));
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

/// A program that renders some octants at a time. Renderer has
///   int octants_at_a_time() const;
///   void render(const BrickMemory&, const OpenOctants&, int first, int count, ImageMemory&);
template <class Vm, class Renderer>
void render_each_octant(Vm& vm, const BrickMemory& brick, const SkySamples& samples,
                        OpenOctants& open, ImageMemory& images, ScalarSums& sums,
                        ImageSink<Vm::kCounted>& sink, Memory<float> harmonics,
                        Renderer& renderer) {
  list_open_octants(vm, brick, open, sink.counts);
  sums.clear(brick.size());
  const int most = renderer.octants_at_a_time();
  for (int first = 0; first < open.size; first += most) {
    const int count = std::min(most, open.size - first);
    vm.begin_batch();
    renderer.render(brick, open, first, count, images);
    for (int i = 0; i < count; ++i) {
      const int probe = open.probe(first + i), octant = open.octant(first + i);
      const Memory<std::int32_t> image = images.image(i, samples);
      sink.take(brick.brick->first_probe + static_cast<std::uint64_t>(probe), octant, image.data,
                samples.words, 1);
      sums.add(probe, octant,
               samples.by_counting ? counted_samples(vm, samples, image)
                                   : selected_worths(vm, samples, image));
    }
  }
  sums.store();
  finish_probes(vm, samples, sums.memory(), brick.size(), harmonics);
}

}  // namespace lanescope
