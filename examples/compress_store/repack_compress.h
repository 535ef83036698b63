// SPDX-License-Identifier: MIT
// REPACK whose buffers are written with compress_store and read with expand_load, where the thesis
// has a prefix sum and a scatter or gather.
#pragma once

#include "compress_store.h"
#include "kernels/micropolygons/repack.h"

namespace lanescope {

/// A policy of the form of PrefixSumCompaction, which see; a place is that of the first record.
struct PackedAccess {
  template <class On, class Lanes>
  static int places_behind(On&, Lanes /*selected*/, int held) {
    return held;
  }

  template <class On, class T, class... Words>
  static void push(On&& on, Memory<T> buffer, int first, const Words&... words) {
    compress_store(on, buffer, first, words...);
  }

  template <class Lanes>
  struct Taken {
    Lanes lanes;
    int places;
  };

  /// Lanes need no rank unless more are free than records are held.
  template <class On, class Lanes>
  static Taken<Lanes> take(On& on, Lanes free, int free_count, int held) {
    if (free_count <= held) return {free, held - free_count};
    return {cmp_le(on, prefix_sum(on, free), held), 0};
  }

  template <class On, class T, class... Rest>
  static auto pop(On& on, Memory<T> buffer, int first, const Rest&... rest) {
    return expand_load(on, buffer, first, rest...);
  }
};

struct StepsWithPackedAccess : PlainSteps {
  using Compaction = PackedAccess;
};

template <class Vm, Micropolygon P, Edges E>
using RepackCompress = BasicRepack<Vm, P, E, StepsWithPackedAccess>;

}  // namespace lanescope
