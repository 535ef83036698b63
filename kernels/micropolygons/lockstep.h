// SPDX-License-Identifier: MIT
// LOCKSTEP (the thesis, 3.2.1, figure 3.3): W micropolygons at a time, one in each lane; every lane
// tests its i-th candidate in iteration i, until the largest box is done.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "kernels/micropolygons/steps.h"
#include "kernels/micropolygons/vector_kernel.h"

namespace lanescope {

/// In the order of Lockstep::Stage.
inline constexpr std::array<std::string_view, 4> kLockstepStages{"Setup", "Bound", "Test",
                                                                 "Process"};

/// With the steps of `Steps`, which see in steps.h.
template <class Vm, Micropolygon P, Edges E, class Steps>
class BasicLockstep {
 public:
  enum Stage : std::size_t { kSetup, kBound, kTest, kProcess };
  static constexpr std::size_t kStageCount = kLockstepStages.size();
  static_assert(kProcess + 1 == kStageCount, "a stage has no name, or a name no stage");
  static constexpr std::size_t kCounterCount = kConflictHits + 1;

  BasicLockstep(Vm& vm, const ProgramOptions& options, RasterizerCounts& counts,
                HitSink<Vm::kCounted>& sink)
      : vm_(vm), cells_(options.frame->grid()), counts_(counts), sink_(sink) {}

  void rasterize(const PacketMemory<P>& packet, int size, std::uint64_t first_id) {
    auto setup = vm_.site(kSetup);
    auto bounding = vm_.site(kBound);
    auto testing = vm_.site(kTest);
    auto ruling = vm_.site(kTest);
    Processing processing(vm_);

    for (int first = 0; first < size; first += vm_.width()) {
      const auto valid = vm_.first_n(size - first);
      vm_.begin_batch();
      const auto batch = set_up<Vm, P>(setup, packet, first, valid);
      if constexpr (Vm::kCounted) count_batch(counts_, batch, valid);
      if (!batch.any_alive) continue;

      const Bounded bounded = bound_batch(bounding, batch, packet, first);
      if constexpr (Vm::kCounted)
        count_boxes(counts_, bounded.box, batch.alive, bounded.with_candidates);
      const Hits hits{sink_, first_id + static_cast<std::uint64_t>(first)};

      Cursor<Vm> at{bounded.box.first_column, bounded.box.first_row, bounded.box.first_sample};
      Lanes active = bounded.with_candidates;
      for (std::int32_t i = 1; i <= bounded.most_candidates; ++i) {
        const auto sample = at.sample;
        Float px, py;
        EdgeValues<Vm, P> values;
        Coverage<Vm> coverage;
        Lanes unfinished;
        {
          auto on = testing.on(active);
          std::tie(px, py) = place_sample<Vm>(on, at.column, at.row, at.sample, cells_);
          coverage = test(on, batch.positions, bounded, px, py, values);
          at = advance<Vm>(on, at, bounded.box.first_column, bounded.box.last_column,
                           bounded.box.row_step);
          unfinished = cmp_gt(on, bounded.box.candidates, i);
        }
        const auto evaluate = [&](auto& on) LANESCOPE_INLINE_LAMBDA {
          if constexpr (!kTestGivesValues)
            values = inline_edges<Vm, P>(on, batch.positions, px, py);
        };
        if (coverage.any_on_edge) [[unlikely]] {
          if constexpr (!kTestGivesValues) {
            auto on = ruling.on(coverage.on_edge);
            evaluate(on);
          }
          add_owned_samples<Vm, P>(ruling, coverage, batch.positions, values);
        }
        if (coverage.any_inside) {
          auto on = processing.site.on(coverage.inside);
          evaluate(on);
          process(on, processing.merging, hits, bounded, values, sample);
        }
        active = unfinished;
      }
    }
  }

 private:
  using Float = typename Vm::Float;
  using Lanes = typename Vm::Lanes;
  using EdgeTest = typename Steps::EdgeTest;
  using FrameAccess = typename Steps::FrameAccess;
  using MergingSites = typename FrameAccess::template Sites<Vm>;
  static constexpr bool kTestGivesValues = E == Edges::kPrecomputed || EdgeTest::kGivesValues;

  struct Processing {
    explicit Processing(Vm& vm) : site(vm.site(kProcess)), merging(vm, kProcess) {}
    typename Vm::Site site;
    MergingSites merging;
  };

  /// What stays in registers from *Bound* on.
  struct Bounded {
    Box<Vm> box;
    Lanes with_candidates;
    std::int32_t most_candidates;
    Float inverse_area;              ///< Triangles.
    EdgeEquations<Vm, P> equations;  ///< Edges::kPrecomputed.
    Float shades[kCorners<P>][kShades];
  };

  template <class BoundSite>
  LANESCOPE_INLINE Bounded bound_batch(BoundSite& site, const Batch<Vm, P>& batch,
                                       const PacketMemory<P>& packet, std::int64_t first) {
    Bounded bounded;
    auto on = site.on(batch.alive);
    bounded.box = bound<Vm, P>(on, batch.positions, cells_);
    bounded.most_candidates = hmax(on, bounded.box.candidates);
    bounded.with_candidates = cmp_gt(on, bounded.box.candidates, 0);
    if constexpr (E == Edges::kPrecomputed)
      bounded.equations = edge_equations<Vm, P>(on, batch.positions, batch.area);
    if constexpr (P == Micropolygon::kTriangle) bounded.inverse_area = rcp(on, batch.area);
    host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
      host::unroll<kShades>([&](auto i) LANESCOPE_INLINE_LAMBDA {
        bounded.shades[k][i] = load(on, packet.shade(k, i), first);
      });
    });
    return bounded;
  }

  /// *Test* at the positions (px, py).
  template <class On>
  LANESCOPE_INLINE Coverage<Vm> test(On& on, const Positions<Vm, P>& positions,
                                     const Bounded& bounded, const Float& px, const Float& py,
                                     EdgeValues<Vm, P>& values) {
    if constexpr (E == Edges::kInline) {
      return EdgeTest::template test<Vm, P>(on, positions, px, py, values);
    } else {
      values =
          precomputed_edges<Vm, P>(on, bounded.equations, positions.x[0], positions.y[0], px, py);
      return point_in_polygon<Vm, P>(on, values);
    }
  }

  /// *Process*, in a block of the hits.
  template <class On>
  LANESCOPE_INLINE void process(On& on, MergingSites& merging, Hits<HitSink<Vm::kCounted>> hits,
                                const Bounded& bounded, const EdgeValues<Vm, P>& values,
                                const typename Vm::Int& sample) {
    const auto weights = corner_weights<Vm, P>(on, values, bounded.inverse_area);
    Float shade[kShades];
    host::unroll<kShades>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      shade[i] = interpolate(on, weights, [&](auto k) LANESCOPE_INLINE_LAMBDA -> const Float& {
        return bounded.shades[k][i];
      });
    });
    FrameAccess::merge(merging, on, hits, sample, shade[0], shade[1], shade[2], shade[3], shade[4]);
  }

  Vm& vm_;
  Cells cells_;
  RasterizerCounts& counts_;
  HitSink<Vm::kCounted>& sink_;
};

/// As the thesis has it.
template <class Vm, Micropolygon P, Edges E>
using Lockstep = BasicLockstep<Vm, P, E, PlainSteps>;

}  // namespace lanescope
