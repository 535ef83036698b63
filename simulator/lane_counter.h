// SPDX-License-Identifier: MIT
// Counts, for each lane, how often it was on: one add of a narrow counter for each group of lanes.
#pragma once

#include <cstdint>

#include "simulator/vector.h"

namespace lanescope::host::inline LANESCOPE_HOST {

/// Counters of 16 bits in one host register, for a machine of W lanes: the lanes of a chunk, or of
/// two.
template <int W>
constexpr int counters_of_16_bits() {
  constexpr int kRegister = kMaskRegisters ? 32 : chunk_lanes<W>() == 8 ? 16 : 8;
  return W % kRegister == 0 ? kRegister : chunk_lanes<W>();
}

}  // namespace lanescope::host::inline LANESCOPE_HOST

namespace lanescope::inline LANESCOPE_HOST {

/// Counters of 16 bits for W lanes. After kCapacity additions they must be taken and reset.
/// Adding costs one masked add for 16 or 32 lanes on AVX-512.
template <int W>
class LaneCounter {
 public:
  static constexpr std::int32_t kCapacity = 65535;
  static constexpr int kGroupLanes = host::counters_of_16_bits<W>();
  static constexpr int kGroups = (W + kGroupLanes - 1) / kGroupLanes;
  static constexpr int kLanes = kGroupLanes * kGroups;

  /// Adds 1 to the lanes of the mask.
  LANESCOPE_INLINE void add(Mask<W> active) {
    host::unroll<kGroups>([&](auto g) LANESCOPE_INLINE_LAMBDA {
      groups_[g] = increment(groups_[g], bits_of_group<g>(active));
    });
  }

  LANESCOPE_INLINE void reset() {
    host::unroll<kGroups>([&](auto g) LANESCOPE_INLINE_LAMBDA { groups_[g] = Group{}; });
  }

  /// Copies group by group: a counter that is copied as a whole would be kept in memory.
  LANESCOPE_INLINE LaneCounter copy() const {
    LaneCounter c;
    host::unroll<kGroups>([&](auto g) LANESCOPE_INLINE_LAMBDA { c.groups_[g] = groups_[g]; });
    return c;
  }

  /// The count of each lane.
  std::array<std::uint16_t, kLanes> counts() const {
    std::array<std::uint16_t, kLanes> lanes;
    std::memcpy(lanes.data(), groups_, sizeof groups_);
    return lanes;
  }

 private:
  using Group = host::Chunk<std::uint16_t, kGroupLanes>;

  template <int G>
  LANESCOPE_INLINE static std::uint32_t bits_of_group(Mask<W> active) {
    if constexpr (host::kMaskRegisters && kGroupLanes == kChunkLanes<W>)
      return active.chunk(G);
    else if constexpr (host::kMaskRegisters)
      return active.template pair_bits<G>();
    else
      return static_cast<std::uint32_t>(active.bits() >> (G * kGroupLanes));
  }

  LANESCOPE_INLINE static Group increment(Group counts, std::uint32_t bits) {
#ifdef LANESCOPE_AVX512
    if constexpr (kGroupLanes == 32)
      return (Group)_mm512_mask_add_epi16((__m512i)counts, bits, (__m512i)counts,
                                          _mm512_set1_epi16(1));
    if constexpr (kGroupLanes == 16)
      return (Group)_mm256_mask_add_epi16((__m256i)counts, static_cast<__mmask16>(bits),
                                          (__m256i)counts, _mm256_set1_epi16(1));
    if constexpr (kGroupLanes == 8)
      return (Group)_mm_mask_add_epi16((__m128i)counts, static_cast<__mmask8>(bits),
                                       (__m128i)counts, _mm_set1_epi16(1));
#endif
    Group lane_bits;
    for (int i = 0; i < kGroupLanes; ++i) lane_bits[i] = static_cast<std::uint16_t>(1u << (i % 16));
    return counts - (Group)((lane_bits & static_cast<std::uint16_t>(bits)) == lane_bits);
  }

  Group groups_[kGroups] = {};
};

}  // namespace lanescope::inline LANESCOPE_HOST
