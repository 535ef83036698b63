// SPDX-License-Identifier: MIT
// What the voxel programs share: finding the open octants of probes, and the ends of *Project*.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "kernels/voxels/vector_kernel.h"

namespace lanescope {

/// In the order of ProbeStage.
inline constexpr std::array<std::string_view, 3> kProbeStages{"Scan", "Merge", "Project"};
enum ProbeStage : std::size_t { kScan, kMerge, kProject };

/// Bit b of a mask of rows or cubes, lowest first.
template <class Visit>
LANESCOPE_INLINE void for_each_bit(std::int32_t mask, const Visit& visit) {
  for (auto bits = static_cast<std::uint32_t>(mask); bits != 0; bits &= bits - 1)
    visit(std::countr_zero(bits));
}

/// Where the rows of an octant begin, in each lane.
template <class Vm>
struct FirstCubes {
  typename Vm::Int row, bit;
};

/// Those of the probes first, first + 1 ...
template <class Vm, class On>
LANESCOPE_INLINE FirstCubes<Vm> first_cubes(On& on, const Level& level, int first, int octant) {
  using namespace isa;
  const auto row = load(on, memory_of(level.row, "rows of probes"), first);
  auto bit = load(on, memory_of(level.bit, "bits of probes"), first);
  if (octant & 1) bit = sub(on, level.turned_bit, bit);
  return {add(on, row, level.start[static_cast<std::size_t>(octant)]), bit};
}

/// The cubes of a row of an octant in each lane, as bits: bit 0 is the nearest. Those of
/// `row_bits`, a vector or a scalar, count.
template <class Vm, class On, class RowBits>
LANESCOPE_INLINE typename Vm::Int cubes_of_row(On& on, Memory<const std::int32_t> rows,
                                               const typename Vm::Int& row,
                                               const typename Vm::Int& bit,
                                               const RowBits& row_bits) {
  using namespace isa;
  return bit_and(on, shr(on, gather(on, rows, row), bit), row_bits);
}

/// An octant of a probe that is to be rendered: 8 probe + octant.
struct OpenOctants {
  OpenOctants(bool checked) : items(kMost, "open octants", checked) {}

  static constexpr std::size_t kMost =
      std::size_t{kOctants} * kBrickCorners * kBrickCorners * kBrickCorners;
  Buffer<std::int32_t> items;
  int size = 0;

  int probe(int i) const { return items.data()[i] / kOctants; }
  int octant(int i) const { return items.data()[i] % kOctants; }
};

/// *Scan* of the nearest cubes: lists the octants of all probes that are not blocked, W probes and
/// one octant at a time.
template <class Vm>
void list_open_octants(Vm& vm, const BrickMemory& brick, OpenOctants& open,
                       [[maybe_unused]] ProbeCounts& counts) {
  using namespace isa;
  auto scanning = vm.site(kScan);
  open.size = 0;
  for (int first = 0; first < brick.size(); first += vm.width()) {
    const auto valid = vm.first_n(brick.size() - first);
    for (int octant = 0; octant < kOctants; ++octant) {
      int found;
      typename Vm::Int listed;
      {
        auto on = scanning.on(valid);
        const FirstCubes<Vm> cubes = first_cubes<Vm>(on, brick.levels[0], first, octant);
        const auto nearest = cubes_of_row<Vm>(on, brick.rows(), cubes.row, cubes.bit, 1);
        const auto is_open = cmp_eq(on, nearest, 0);
        const auto item = add(on, mul(on, add(on, lane_index(on), first), kOctants), octant);
        listed = compress(on, is_open, item);
        found = count(on, is_open);
      }
      store(scanning.on(vm.first_n(found)), open.items.memory(), open.size, listed);
      open.size += found;
      if constexpr (Vm::kCounted)
        counts[kOctantsBlocked] += static_cast<std::uint64_t>(valid.count() - found);
    }
  }
}

/// The harmonics of a brick's probes while octants are added up: [harmonic][probe], in units of
/// SkySamples::scale.
struct HarmonicSums {
  HarmonicSums(bool checked) : sums(kHarmonics * kMost, "sums of harmonics", checked) {}

  static constexpr std::size_t kMost = std::size_t{kBrickCorners} * kBrickCorners * kBrickCorners;
  Memory<std::int32_t> of(int harmonic) {
    return sums.memory().part(static_cast<std::size_t>(harmonic) * kMost, kMost);
  }
  Buffer<std::int32_t> sums;
};

/// From the sums of the probes first, first + 1 ... to harmonics in the output; `sum_of(h)` is that
/// of harmonic h.
template <class On, class SumOf>
LANESCOPE_INLINE void store_harmonics(On& on, const SkySamples& samples, Memory<float> harmonics,
                                      int first, const SumOf& sum_of) {
  using namespace isa;
  const auto place = mul(on, add(on, lane_index(on), first), kHarmonics);
  host::unroll<kHarmonics>([&](auto h) LANESCOPE_INLINE_LAMBDA {
    const auto sum = convert_to_float(on, sum_of(h));
    scatter(on, harmonics.part(h, harmonics.size - h), place,
            mul(on, sum, static_cast<float>(samples.scale[h])));
  });
}

/// The end of *Project*: from sums to harmonics, W probes at a time.
template <class Vm>
void finish_probes(Vm& vm, const SkySamples& samples, HarmonicSums& sums, int size,
                   Memory<float> harmonics) {
  auto finishing = vm.site(kProject);
  for (int first = 0; first < size; first += vm.width()) {
    auto on = finishing.on(vm.first_n(size - first));
    store_harmonics(on, samples, harmonics, first, [&](auto h) LANESCOPE_INLINE_LAMBDA {
      return isa::load(on, sums.of(h), first);
    });
  }
}

}  // namespace lanescope
