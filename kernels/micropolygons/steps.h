// SPDX-License-Identifier: MIT
// The steps of LOCKSTEP and REPACK that an instruction of one's own may replace, as policies: a
// program is its class with a struct like PlainSteps. A kernel with other steps derives from it and
// names another policy; all that is not named stays as in the thesis.
//
//   struct MySteps : PlainSteps { using Compaction = MyCompaction; };
//   template <class Vm, Micropolygon P, Edges E> using MyRepack = BasicRepack<Vm, P, E, MySteps>;
#pragma once

#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/stages.h"

namespace lanescope {

/// How REPACK's buffers are written and read side by side (the thesis, 3.2.2): a prefix sum gives
/// each lane its place. A buffer is a stack of records; `held` is how many it holds. Records have a
/// word or two.
struct PrefixSumCompaction {
  /// The places that the selected lanes of a block get, behind what is held.
  template <class On, class Lanes>
  LANESCOPE_INLINE static auto places_behind(On& on, Lanes selected, int held) {
    return add(on, prefix_sum(on, selected), held - 1);
  }

  /// Writes the records of the active lanes, those that were selected.
  template <class On, class T, class Places, class... Words>
  LANESCOPE_INLINE static void push(On&& on, Memory<T> buffer, const Places& places,
                                    const Words&... words) {
    if constexpr (sizeof...(Words) == 1)
      scatter(on, buffer, places, words...);
    else
      scatter_pair(on, buffer, places, words...);
  }

  /// The lanes that take a record from the top, and their places.
  template <class Lanes, class Places>
  struct Taken {
    Lanes lanes;
    Places places;
  };

  /// Chooses among the `free_count` lanes of `free`, those of the block, as many as records are
  /// held.
  template <class On, class Lanes>
  LANESCOPE_INLINE static auto take(On& on, Lanes free, int /*free_count*/, int held) {
    const auto rank = prefix_sum(on, free);
    const auto loaded = cmp_le(on, rank, held);
    const auto places = sub(on, held, rank);
    return Taken<Lanes, decltype(rank)>{loaded, places};
  }

  /// Reads the records of the active lanes, those that were taken; the others keep theirs.
  template <class On, class T, class Places, class... Rest>
  LANESCOPE_INLINE static auto pop(On& on, Memory<T> buffer, const Places& places,
                                   const Rest&... rest) {
    if constexpr (sizeof...(Rest) == 1)
      return gather(on, buffer, places, rest...);
    else
      return gather_pair(on, buffer, places, rest...);
  }
};

/// *Test* with edges from the vertices: their functions, then what they say of the sample.
struct EdgesOneByOne {
  /// Whether `values` are those of the edge functions afterwards; if not, *Process* evaluates them.
  static constexpr bool kGivesValues = true;

  template <class Vm, Micropolygon P, class On>
  LANESCOPE_INLINE static Coverage<Vm> test(On& on, const Positions<Vm, P>& positions,
                                            const typename Vm::Float& px,
                                            const typename Vm::Float& py,
                                            EdgeValues<Vm, P>& values) {
    values = inline_edges<Vm, P>(on, positions, px, py);
    return point_in_polygon<Vm, P>(on, values);
  }
};

/// What a hit carries from *Test* to *Process* beside micropolygon and sample: nothing. REPACK
/// evaluates the edge functions again.
struct NothingCarried {
  static constexpr int kWords = 0;  ///< Of a record, for each hit; or 4, the values at the edges.
};

/// Frame access of *Process*: one instruction, in which lanes follow each other.
struct MergeInLaneOrder {
  template <class Vm>
  struct Sites {
    Sites(Vm&, std::size_t /*stage*/) {}
  };

  /// In the block of *Process*. `fragment` is what follows the hits as operands of frame_merge:
  /// number (in REPACK), sample, depth and channels.
  template <class Vm, class On, class AnyHits, class... Fragment>
  LANESCOPE_INLINE static void merge(Sites<Vm>&, On& on, AnyHits hits,
                                     const Fragment&... fragment) {
    frame_merge(on, hits, fragment...);
  }
};

/// Which hits of REPACK's buffer a batch of *Process* consists of: those on top.
struct HitsOnTop {
  template <class Vm>
  struct Sites {
    Sites(Vm&, std::size_t /*stage*/) {}
  };

  /// The hits of a batch, at the places `first` and on, in the lanes `lanes`.
  template <class Vm>
  struct Batch {
    typename Vm::Lanes lanes;
    int first;

    /// Micropolygons and samples, in the block of *Process*.
    template <class On>
    LANESCOPE_INLINE auto load(On& on, Memory<std::int32_t> buffer) const {
      return load_pair(on, buffer, first);
    }
  };

  /// Takes at most W of the `held` hits, and at least one, from the buffer.
  template <class Vm>
  LANESCOPE_INLINE static Batch<Vm> take(Vm& vm, Sites<Vm>&, Memory<std::int32_t> /*buffer*/,
                                         int& held) {
    const int count = std::min(held, vm.width());
    held -= count;
    return {vm.first_n(count), held};
  }
};

/// The steps as the thesis has them.
struct PlainSteps {
  using Compaction = PrefixSumCompaction;  ///< REPACK
  using EdgeTest = EdgesOneByOne;          ///< LOCKSTEP and REPACK, Edges::kInline
  using Carried = NothingCarried;          ///< REPACK
  using FrameAccess = MergeInLaneOrder;    ///< LOCKSTEP and REPACK
  using HitBatch = HitsOnTop;              ///< REPACK
};

}  // namespace lanescope
