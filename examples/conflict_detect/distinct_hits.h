// SPDX-License-Identifier: MIT
// A batch builder after McCormack et al.: batches of hits that are all of different samples.
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>

#include "frame_write.h"

namespace lanescope {

/// The batches of *Process*, a policy of the form of HitsOnTop, which see. Lanes whose sample an
/// earlier lane has put their hit aside and take the next one from the buffer, as long as there is
/// one; those put aside go back to the buffer.
struct DistinctHits {
  template <class Vm>
  struct Sites {
    Sites(Vm& vm, std::size_t stage)
        : loading(vm.site(stage)),
          looking(vm.site(stage)),
          deferring(vm.site(stage)),
          refilling(vm.site(stage)),
          returning(vm.site(stage)),
          aside(4 * static_cast<std::size_t>(vm.width()), "hits put aside", vm.checks()) {}
    typename Vm::Site loading, looking, deferring, refilling, returning;
    Buffer<std::int32_t> aside;  ///< (micropolygon, sample)
  };

  template <class Vm>
  struct Batch {
    typename Vm::Lanes lanes;
    typename Vm::Int micropolygon, sample;

    template <class On>
    auto load(On&, Memory<std::int32_t> /*buffer*/) const {
      return std::pair(micropolygon, sample);
    }
  };

  template <class Vm>
  static Batch<Vm> take(Vm& vm, Sites<Vm>& sites, Memory<std::int32_t> buffer, int& held) {
    Batch<Vm> batch = load_top(vm, sites, buffer, held);
    int aside = 0;
    for (;;) {
      auto on = sites.looking.on(batch.lanes);
      auto extra = on.overhead();
      const auto late = conflict(extra, batch.sample);
      if (!any(extra, late)) break;
      refill(sites, buffer, batch, late, held, aside);
    }
    give_back(vm, sites, buffer, held, aside);
    return batch;
  }

 private:
  template <class Vm>
  static Batch<Vm> load_top(Vm& vm, Sites<Vm>& sites, Memory<std::int32_t> buffer, int& held) {
    const int count = std::min(held, vm.width());
    held -= count;
    auto on = sites.loading.on(vm.first_n(count));
    const auto [micropolygon, sample] = load_pair(on.overhead(), buffer, held);
    return {on.active(), micropolygon, sample};
  }

  /// Puts the hits of `late` aside and loads others in their place; lanes that get none end.
  template <class Vm>
  static void refill(Sites<Vm>& sites, Memory<std::int32_t> buffer, Batch<Vm>& batch,
                     typename Vm::Lanes late, int& held, int& aside) {
    typename Vm::Int place;
    typename Vm::Lanes refilled;
    {
      auto on = sites.deferring.on(late);
      auto extra = on.overhead();
      const auto rank = prefix_sum(extra, late);
      scatter_pair(extra, sites.aside.memory(), add(extra, rank, aside - 1), batch.micropolygon,
                   batch.sample);
      refilled = cmp_le(extra, rank, held);
      place = sub(extra, held, rank);
    }
    aside += late.count();
    held -= refilled.count();
    batch.lanes = batch.lanes & (refilled | ~late);
    if (!refilled.any()) return;
    auto on = sites.refilling.on(refilled);
    std::tie(batch.micropolygon, batch.sample) =
        gather_pair(on.overhead(), buffer, place, batch.micropolygon, batch.sample);
  }

  template <class Vm>
  static void give_back(Vm& vm, Sites<Vm>& sites, Memory<std::int32_t> buffer, int& held,
                        int aside) {
    while (aside > 0) {
      const int count = std::min(aside, vm.width());
      aside -= count;
      auto on = sites.returning.on(vm.first_n(count));
      auto extra = on.overhead();
      const auto [micropolygon, sample] = load_pair(extra, sites.aside.memory(), aside);
      scatter_pair(extra, buffer, add(extra, lane_index(extra), held), micropolygon, sample);
      held += count;
    }
  }
};

struct StepsWithDistinctHits : PlainSteps {
  using HitBatch = DistinctHits;
  using FrameAccess = AllAtOnce;
};

}  // namespace lanescope
