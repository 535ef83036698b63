// SPDX-License-Identifier: MIT
// Frame access in parallel, and three ways to see to it that no two lanes of one execution have the
// same sample.
#pragma once

#include "kernels/micropolygons/steps.h"

namespace lanescope {

/// frame_write(on, hits, ...), with the operands of frame_merge: gather, depth test and scatter of
/// all active lanes at once. Their samples must be distinct; a checked machine sees to it.
struct FrameWrite : FrameUpdate<false> {
  static constexpr InstructionInfo kInfo{
      "frame_write", "depth test and colour write of sample[i], all lanes at once",
      InstructionClass::kSpecial};
  template <int L, class F, class... Operands>
  static void touch(Mask<L> active, F&& f, const Operands&... operands) {
    FrameUpdate::touch(
        active,
        [&](int lane, const auto& frame, std::int64_t sample, Access) {
          f(lane, frame, sample, Access::kStore);
        },
        operands...);
  }
};
inline constexpr Instruction<FrameWrite> frame_write;

/// Of the operands behind the hits, the samples: the last ones before depth and four channels.
template <class First, class... Rest>
const auto& sample_of(const First& first, const Rest&... rest) {
  if constexpr (sizeof...(Rest) == 5)
    return first;
  else
    return sample_of(rest...);
}

/// Sites for one lane after another.
template <class Vm>
struct OneLaneSites {
  OneLaneSites(Vm& vm, std::size_t stage) : apart(vm.site(stage)), alone(vm.site(stage)) {}
  typename Vm::Site apart, alone;

  template <class AnyHits, class... Fragment>
  void write_each(typename Vm::Lanes lanes, AnyHits hits, const Fragment&... fragment) {
    for_each_lane(lanes, [&](int lane) {
      auto on = alone.on(Vm::Lanes::from_bits(std::uint64_t{1} << lane));
      frame_write(on, hits, fragment...);
    });
  }
};

/// Frame access, a policy of the form of MergeInLaneOrder: wholly serialized.
struct EachHitAlone {
  template <class Vm>
  using Sites = OneLaneSites<Vm>;

  template <class Vm, class On, class AnyHits, class... Fragment>
  static void merge(OneLaneSites<Vm>& sites, On& on, AnyHits hits, const Fragment&... fragment) {
    hits.sink.observe(on.active(), Vm::look(sample_of(fragment...)));
    sites.write_each(on.active(), hits, fragment...);
  }
};

/// Frame access in parallel; lanes that conflict with an earlier one follow by themselves.
struct ConflictsAlone {
  template <class Vm>
  using Sites = OneLaneSites<Vm>;

  template <class Vm, class On, class AnyHits, class... Fragment>
  static void merge(OneLaneSites<Vm>& sites, On& on, AnyHits hits, const Fragment&... fragment) {
    hits.sink.observe(on.active(), Vm::look(sample_of(fragment...)));
    const auto late = conflict(on, sample_of(fragment...));
    if (!any(on, late)) {
      frame_write(on, hits, fragment...);
      return;
    }
    {
      auto first = sites.apart.on(on.active() & ~late);
      frame_write(first, hits, fragment...);
    }
    sites.write_each(late, hits, fragment...);
  }
};

struct StepsWithEachHitAlone : PlainSteps {
  using FrameAccess = EachHitAlone;
};

struct StepsWithConflictsAlone : PlainSteps {
  using FrameAccess = ConflictsAlone;
};

/// Frame access in parallel, of batches that are free of conflicts.
struct AllAtOnce {
  template <class Vm>
  struct Sites {
    Sites(Vm&, std::size_t) {}
  };

  template <class Vm, class On, class AnyHits, class... Fragment>
  static void merge(Sites<Vm>&, On& on, AnyHits hits, const Fragment&... fragment) {
    hits.sink.observe(on.active(), Vm::look(sample_of(fragment...)));
    frame_write(on, hits, fragment...);
  }
};

}  // namespace lanescope
