// SPDX-License-Identifier: MIT
// What counting needs to know of the masks under which a block was executed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace lanescope {

/// A mask of up to L lanes as it is logged: bit i is lane i.
template <int L>
using LoggedMask = std::conditional_t<L <= 16, std::uint16_t,
                                      std::conditional_t<L <= 32, std::uint32_t, std::uint64_t>>;

/// Sums over masks of up to 64 lanes.
struct MaskSums {
  /// Most bytes of masks that one add() takes.
  static constexpr std::size_t kMostBytes = 1024;

  std::array<std::uint64_t, 64> lanes{};      ///< [i] masks with lane i on.
  std::array<std::uint64_t, 65> histogram{};  ///< [k] masks with k lanes on.

  /// Adds the masks begin ... end - 1. Requires at most kMostBytes. Word is one of LoggedMask.
  template <class Word>
  void add(const Word* begin, const Word* end);
};

}  // namespace lanescope
