// SPDX-License-Identifier: MIT
// The kernel of docs/own-programs.md: one micropolygon at a time, a lane for each candidate sample
// of its box, as rasterizers of large polygons do. The first W samples, the next W, and so on.
// Edges are evaluated by an instruction that the machine does not come with.
#pragma once

#include <array>
#include <string_view>

#include "edge_function.h"
#include "kernels/micropolygons/vector_kernel.h"

namespace lanescope {

/// In the order of OneAtATime::Stage.
inline constexpr std::array<std::string_view, 4> kOneAtATimeStages{"Setup", "Bound", "Test",
                                                                   "Process"};

template <class Vm, Micropolygon P, Edges E>
class OneAtATime {
 public:
  enum Stage : std::size_t { kSetup, kBound, kTest, kProcess };
  static constexpr std::size_t kStageCount = kOneAtATimeStages.size();
  static_assert(kProcess + 1 == kStageCount, "a stage has no name, or a name no stage");
  static constexpr std::size_t kCounterCount = kConflictHits + 1;

  OneAtATime(Vm& vm, const ProgramOptions& options, RasterizerCounts& counts,
             HitSink<Vm::kCounted>& sink)
      : vm_(vm), cells_(options.frame->grid()), counts_(counts), sink_(sink) {}

  void rasterize(const PacketMemory<P>& packet, int size, std::uint64_t first_id) {
    auto setup = vm_.site(kSetup);
    auto bounding = vm_.site(kBound);
    auto testing = vm_.site(kTest);
    auto ruling = vm_.site(kTest);
    auto processing = vm_.site(kProcess);
    for (int i = 0; i < size; ++i) {
      vm_.begin_batch();
      const auto one = vm_.first_n(1);
      const auto batch = set_up<Vm, P>(setup, packet, i, one);
      if constexpr (Vm::kCounted) count_batch(counts_, batch, one);
      if (!batch.any_alive) continue;
      test_all(testing, ruling, processing, packet, i, first_id, bound_one(bounding, batch));
    }
  }

 private:
  using Int = typename Vm::Int;
  using Float = typename Vm::Float;
  using Lanes = typename Vm::Lanes;

  /// The box of the micropolygon, in scalars.
  struct OneBox {
    std::int32_t first_column, first_row, columns, candidates;
  };

  template <class BoundSite>
  OneBox bound_one(BoundSite& site, const Batch<Vm, P>& batch) {
    auto on = site.on(batch.alive);
    const Box<Vm> box = bound<Vm, P>(on, batch.positions, cells_);
    if constexpr (Vm::kCounted)
      count_boxes(counts_, box, batch.alive, cmp_gt(on, box.candidates, 0));
    const auto first = static_cast<std::int32_t>(hmax(on, box.first_column));
    const auto last = static_cast<std::int32_t>(hmax(on, box.last_column));
    return {first, static_cast<std::int32_t>(hmax(on, box.first_row)), last - first + 1,
            hmax(on, box.candidates)};
  }

  template <class TestSite, class ProcessSite>
  void test_all(TestSite& testing, TestSite& ruling, ProcessSite& processing,
                const PacketMemory<P>& packet, int i, std::uint64_t first_id, const OneBox& box) {
    for (int first = 0; first < box.candidates; first += vm_.width()) {
      Positions<Vm, P> positions;
      EdgeValues<Vm, P> values;
      Coverage<Vm> coverage;
      Int sample, number;
      {
        auto on = testing.on(vm_.first_n(box.candidates - first));
        number = broadcast(on, std::int32_t{i});
        const Int candidate = add(on, lane_index(on), std::int32_t{first});
        const Int row = div(on, candidate, box.columns);
        const Int column = add(on, sub(on, candidate, mul(on, row, box.columns)), box.first_column);
        const Int line = add(on, row, box.first_row);
        sample = add(on, mul(on, line, cells_.stride), column);
        const auto [px, py] = place_sample<Vm>(on, convert_to_float(on, column),
                                               convert_to_float(on, line), sample, cells_);
        host::unroll<kCorners<P>>([&](auto k) {
          positions.x[k] = gather(on, packet.x(k), number);
          positions.y[k] = gather(on, packet.y(k), number);
        });
        if constexpr (E == Edges::kPrecomputed)
          values = precomputed_edges<Vm, P>(
              on, edge_equations<Vm, P>(on, positions, doubled_area<Vm, P>(on, positions)),
              positions.x[0], positions.y[0], px, py);
        else
          values = edge_functions(on, positions, px, py);
        coverage = point_in_polygon<Vm, P>(on, values);
      }
      if (coverage.any_on_edge) add_owned_samples<Vm, P>(ruling, coverage, positions, values);
      if (coverage.any_inside)
        process(processing, coverage.inside, packet, first_id, positions, values, number, sample);
    }
  }

  template <class On>
  LANESCOPE_INLINE EdgeValues<Vm, P> edge_functions(On& on, const Positions<Vm, P>& positions,
                                                    const Float& px, const Float& py) {
    Float x[kCorners<P>], y[kCorners<P>];
    host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
      x[k] = sub(on, positions.x[k], px);
      y[k] = sub(on, positions.y[k], py);
    });
    EdgeValues<Vm, P> values;
    host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
      constexpr int kNext = (k + 1) % kCorners<P>;
      values.e[k] = edge_function(on, x[k], y[k], x[kNext], y[kNext]);
    });
    return values;
  }

  template <class ProcessSite>
  void process(ProcessSite& site, Lanes hits, const PacketMemory<P>& packet, std::uint64_t first_id,
               const Positions<Vm, P>& positions, const EdgeValues<Vm, P>& values,
               const Int& number, const Int& sample) {
    auto on = site.on(hits);
    Float inverse_area{};
    if constexpr (P == Micropolygon::kTriangle)
      inverse_area = rcp(on, doubled_area<Vm, P>(on, positions));
    const auto weights = corner_weights<Vm, P>(on, values, inverse_area);
    Float shade[kShades];
    host::unroll<kShades>([&](auto s) {
      shade[s] =
          interpolate(on, weights, [&](auto k) { return gather(on, packet.shade(k, s), number); });
    });
    frame_merge(on, Hits{sink_, first_id}, number, sample, shade[0], shade[1], shade[2], shade[3],
                shade[4]);
  }

  Vm& vm_;
  Cells cells_;
  RasterizerCounts& counts_;
  HitSink<Vm::kCounted>& sink_;
};

}  // namespace lanescope
