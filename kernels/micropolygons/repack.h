// SPDX-License-Identifier: MIT
// REPACK (the thesis, 3.2.2, figure 3.4): three stages with a buffer of 2 W entries before *Test*
// and before *Process*. Survivors of a stage are compacted into the next buffer; lanes of *Test*
// that have finished a box are loaded with the next one (stream loading). The scheduler runs the
// latest stage that can run with a full vector.
//
// Buffers are stacks: entries are pushed and popped at the top, so that an index never wraps. A
// micropolygon in flight is an index into the packet, which stays in memory until the kernel has
// drained at its end.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "kernels/micropolygons/vector_kernel.h"

namespace lanescope {

/// In the order of Repack::Stage.
inline constexpr std::array<std::string_view, 5> kRepackStages{"Setup", "Bound", "Test Stream-load",
                                                               "Test", "Process"};

template <class Vm, Micropolygon P, Edges E>
class Repack {
 public:
  enum Stage : std::size_t { kSetup, kBound, kStreamLoad, kTest, kProcess };
  static constexpr std::size_t kStageCount = kRepackStages.size();
  static_assert(kProcess + 1 == kStageCount, "a stage has no name, or a name no stage");
  static constexpr std::size_t kCounterCount = kRasterizerCounterCount;

  Repack(Vm& vm, const ProgramOptions& options, RasterizerCounts& counts,
         HitSink<Vm::kCounted>& sink)
      : vm_(vm),
        cells_(options.frame->grid()),
        counts_(counts),
        sink_(sink),
        least_free_to_load_(
            std::max(1, static_cast<int>(std::ceil(options.kernel.stream_load_threshold *
                                                   static_cast<float>(vm.width()))))) {}

  std::vector<std::vector<std::uint64_t>> series() const { return working_set_.series(); }

  void rasterize(const PacketMemory<P>& packet, int size, std::uint64_t first_id) {
    const int width = vm_.width();
    Sites sites(vm_);
    TestLanes lanes;
    hold(size);
    working_set_.begin_packet();
    for (int next = 0;;) {
      const bool input_left = next < size;
      const int testable = lanes.busy.count() + queued_;
      if (hits_ >= width) {
        process(sites, packet, first_id, width);
      } else if (testable >= width || (!input_left && testable > 0)) {
        const int busy = lanes.busy.count();
        if (queued_ > 0 && (width - busy >= least_free_to_load_ || busy == 0))
          stream_load(sites, lanes);
        test(sites, packet, lanes);
      } else if (input_left) {
        const bool bounded = bound_batch(sites, packet, next, vm_.first_n(size - next));
        if (Vm::kCounted && bounded) observe_working_set(lanes);
        next += width;
      } else if (hits_ > 0) {
        process(sites, packet, first_id, hits_);
      } else {
        return;
      }
    }
  }

 private:
  using Float = typename Vm::Float;
  using Int = typename Vm::Int;
  using Lanes = typename Vm::Lanes;
  static constexpr bool kTriangles = P == Micropolygon::kTriangle;
  static constexpr bool kPrecomputed = E == Edges::kPrecomputed;
  using Equations = EdgeEquations<Vm, P>;
  static constexpr int kCoefficients = 2 * kCorners<P> + Equations::kInner;

  /// One site for each block of the program.
  struct Sites {
    explicit Sites(Vm& vm)
        : setup(vm.site(kSetup)),
          bounding(vm.site(kBound)),
          queueing(vm.site(kBound)),
          ranking(vm.site(kStreamLoad)),
          loading(vm.site(kStreamLoad)),
          testing(vm.site(kTest)),
          regathering(vm.site(kTest)),
          ruling(vm.site(kTest)),
          compacting(vm.site(kTest)),
          storing(vm.site(kTest)),
          processing(vm.site(kProcess)) {}
    typename Vm::Site setup, bounding, queueing, ranking, loading, testing, regathering, ruling,
        compacting, storing, processing;
  };

  /// What each lane of *Test* is at work on.
  struct TestLanes {
    Lanes busy = Lanes::none();
    Int micropolygon{}, remaining{}, row_step{};
    Float first_column{}, last_column{};
    Cursor<Vm> at{};
  };

  /// Makes room for what is kept of each micropolygon of a packet.
  void hold(int size) {
    if (held_ && size <= held_->size) return;
    held_.emplace(size, vm_.checks());
  }

  /// *Setup* and *Bound* of a batch; survivors are pushed to the queue of *Test*. Returns whether
  /// any micropolygon was left to bound.
  LANESCOPE_INLINE bool bound_batch(Sites& sites, const PacketMemory<P>& packet, int first,
                                    Lanes valid) {
    vm_.begin_batch();
    const auto batch = set_up<Vm, P>(sites.setup, packet, first, valid);
    if constexpr (Vm::kCounted) count_batch(counts_, batch, valid);
    if (!batch.any_alive) return false;

    Box<Vm> box;
    Lanes with_candidates;
    Int place, micropolygon;
    {
      auto on = sites.bounding.on(batch.alive);
      auto extra = on.overhead();
      box = bound<Vm, P>(on, batch.positions, cells_);
      if constexpr (kTriangles)
        store(extra, held_->inverse_area.memory(), first, rcp(on, batch.area));
      if constexpr (kPrecomputed)
        store_equations(extra, edge_equations<Vm, P>(on, batch.positions, batch.area), first);
      with_candidates = cmp_gt(on, box.candidates, 0);
      place = add(extra, prefix_sum(extra, with_candidates), queued_ - 1);
      micropolygon = add(extra, lane_index(extra), first);
      queued_ += count(extra, with_candidates);
    }
    auto on = sites.queueing.on(with_candidates);
    auto extra = on.overhead();
    scatter_pair(extra, queue_.columns.memory(), place, box.first_column, box.last_column);
    scatter(extra, queue_.row.memory(), place, box.first_row);
    scatter_pair(extra, queue_.micropolygon.memory(), place, micropolygon, box.candidates);
    scatter_pair(extra, queue_.samples.memory(), place, box.first_sample, box.row_step);
    if constexpr (Vm::kCounted) count_boxes(counts_, box, batch.alive, with_candidates);
    return true;
  }

  /// *Test Stream-load*: free lanes take boxes from the queue.
  LANESCOPE_INLINE void stream_load(Sites& sites, TestLanes& lanes) {
    Lanes loaded;
    Int place;
    {
      const Lanes free = vm_.all() & ~lanes.busy;
      auto on = sites.ranking.on(free);
      auto extra = on.overhead();
      const auto rank = prefix_sum(extra, free);
      loaded = cmp_le(extra, rank, queued_);
      place = sub(extra, queued_, rank);
    }
    auto on = sites.loading.on(loaded);
    auto extra = on.overhead();
    std::tie(lanes.first_column, lanes.last_column) =
        gather_pair(extra, queue_.columns.memory(), place, lanes.first_column, lanes.last_column);
    lanes.at.column = move(extra, lanes.first_column, lanes.at.column);
    lanes.at.row = gather(extra, queue_.row.memory(), place, lanes.at.row);
    std::tie(lanes.micropolygon, lanes.remaining) = gather_pair(
        extra, queue_.micropolygon.memory(), place, lanes.micropolygon, lanes.remaining);
    std::tie(lanes.at.sample, lanes.row_step) =
        gather_pair(extra, queue_.samples.memory(), place, lanes.at.sample, lanes.row_step);
    queued_ -= loaded.count();
    lanes.busy = lanes.busy | loaded;
  }

  /// *Test*: one candidate of each busy lane; hits are pushed to the queue of *Process*.
  LANESCOPE_INLINE void test(Sites& sites, const PacketMemory<P>& packet, TestLanes& lanes) {
    const Lanes active = lanes.busy;
    const Int sample = lanes.at.sample;
    Coverage<Vm> coverage;
    Positions<Vm, P> positions;
    EdgeValues<Vm, P> values;
    {
      auto on = sites.testing.on(active);
      auto extra = on.overhead();
      const auto [px, py] = place_sample<Vm>(on, lanes.at.column, lanes.at.row, sample, cells_);
      values = gathered_edges(extra, on, packet, lanes.micropolygon, px, py, positions);
      coverage = point_in_polygon<Vm, P>(on, values);
      lanes.at = advance<Vm>(on, lanes.at, lanes.first_column, lanes.last_column, lanes.row_step);
      lanes.remaining = sub(extra, lanes.remaining, 1);
      lanes.busy = cmp_gt(on, lanes.remaining, 0);
    }
    if (coverage.any_on_edge) [[unlikely]]
      rule(sites, packet, lanes.micropolygon, coverage, positions, values);
    if (coverage.any_inside) compact(sites, active, coverage.inside, lanes.micropolygon, sample);
  }

  /// The fill rule for samples on edges; edge equations have not gathered all positions.
  LANESCOPE_INLINE void rule(Sites& sites, const PacketMemory<P>& packet, const Int& micropolygon,
                             Coverage<Vm>& coverage, Positions<Vm, P>& positions,
                             const EdgeValues<Vm, P>& values) {
    if constexpr (kPrecomputed) {
      auto on = sites.regathering.on(coverage.on_edge);
      positions = gather_positions(on.overhead(), packet, micropolygon);
    }
    add_owned_samples<Vm, P>(sites.ruling, coverage, positions, values);
  }

  LANESCOPE_INLINE void compact(Sites& sites, Lanes active, Lanes hits, const Int& micropolygon,
                                const Int& sample) {
    Int place;
    int hit_count;
    {
      auto on = sites.compacting.on(active);
      auto extra = on.overhead();
      place = add(extra, prefix_sum(extra, hits), hits_ - 1);
      hit_count = count(extra, hits);
    }
    auto on = sites.storing.on(hits);
    scatter_pair(on.overhead(), hit_queue_.memory(), place, micropolygon, sample);
    hits_ += hit_count;
  }

  /// *Process* of the last `count` hits of the queue. Edges are evaluated again: at full
  /// utilization that costs less than passing them through the queue under the mask of hits.
  LANESCOPE_INLINE void process(Sites& sites, const PacketMemory<P>& packet, std::uint64_t first_id,
                                int count) {
    hits_ -= count;
    auto on = sites.processing.on(vm_.first_n(count));
    auto extra = on.overhead();
    const auto [micropolygon, sample] = load_pair(extra, hit_queue_.memory(), hits_);
    const auto row = div(extra, sample, cells_.stride);
    const auto column = sub(extra, sample, mul(extra, row, cells_.stride));
    const auto [px, py] = place_sample<Vm>(extra, convert_to_float(extra, column),
                                           convert_to_float(extra, row), sample, cells_);
    Positions<Vm, P> positions;
    const auto values = gathered_edges(extra, extra, packet, micropolygon, px, py, positions);
    Float inverse_area;
    if constexpr (kTriangles)
      inverse_area = gather(extra, held_->inverse_area.memory(), micropolygon);
    const auto weights = corner_weights<Vm, P>(on, values, inverse_area);
    Float shade[kShades];
    host::unroll<kShades>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      shade[i] = interpolate(on, weights, [&](auto k) LANESCOPE_INLINE_LAMBDA {
        return gather(on, packet.shade(k, i), micropolygon);
      });
    });
    frame_merge(on, Hits{sink_, first_id}, micropolygon, sample, shade[0], shade[1], shade[2],
                shade[3], shade[4]);
  }

  template <class On>
  LANESCOPE_INLINE Positions<Vm, P> gather_positions(On&& on, const PacketMemory<P>& packet,
                                                     const Int& micropolygon) {
    Positions<Vm, P> positions;
    host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
      positions.x[k] = gather(on, packet.x(k), micropolygon);
      positions.y[k] = gather(on, packet.y(k), micropolygon);
    });
    return positions;
  }

  /// Edge functions of micropolygons by index. Gathers are issued in `extra`, arithmetic in `on`.
  template <class Extra, class On>
  LANESCOPE_INLINE EdgeValues<Vm, P> gathered_edges(Extra& extra, On& on,
                                                    const PacketMemory<P>& packet,
                                                    const Int& micropolygon, const Float& px,
                                                    const Float& py, Positions<Vm, P>& positions) {
    if constexpr (kPrecomputed) {
      const auto x = gather(extra, packet.x(0), micropolygon);
      const auto y = gather(extra, packet.y(0), micropolygon);
      return precomputed_edges<Vm, P>(on, gather_equations(extra, micropolygon), x, y, px, py);
    } else {
      positions = gather_positions(extra, packet, micropolygon);
      return inline_edges<Vm, P>(on, positions, px, py);
    }
  }

  /// Coefficient i of the equations: those of a, of b, of c.
  template <class AnyEquations>
  static auto& coefficient(AnyEquations& equations, int i) {
    if (i < kCorners<P>) return equations.a[i];
    return i < 2 * kCorners<P> ? equations.b[i - kCorners<P>] : equations.c[i - 2 * kCorners<P>];
  }

  template <class On>
  LANESCOPE_INLINE void store_equations(On& on, const Equations& equations, int first) {
    host::unroll<kCoefficients>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      store(on, held_->coefficients(i), first, coefficient(equations, i));
    });
  }

  template <class On>
  LANESCOPE_INLINE Equations gather_equations(On& on, const Int& micropolygon) {
    Equations equations;
    host::unroll<kCoefficients>([&](auto i) LANESCOPE_INLINE_LAMBDA {
      coefficient(equations, i) = gather(on, held_->coefficients(i), micropolygon);
    });
    return equations;
  }

  /// Counts the micropolygons that are alive: in the queue of *Test*, in its lanes, or with a hit
  /// in the queue of *Process*; each once.
  void observe_working_set(const TestLanes& lanes) {
    ++held_->observation;
    std::uint64_t alive = static_cast<std::uint64_t>(queued_);
    const auto see = [&](std::int32_t micropolygon) {
      std::uint64_t& seen = held_->seen[static_cast<std::size_t>(micropolygon)];
      alive += seen != held_->observation;
      seen = held_->observation;
    };
    const auto testing = Vm::look(lanes.micropolygon).lanes();
    for_each_lane(lanes.busy, [&](int i) { see(testing[static_cast<std::size_t>(i)]); });
    for (int i = 0; i < hits_; ++i) see(hit_queue_.data()[2 * i]);
    counts_[kWorkingSetSum] += alive;
    counts_[kWorkingSetObservations] += 1;
    counts_[kWorkingSetMaximum] = std::max(counts_[kWorkingSetMaximum], alive);
    working_set_.observe(alive);
  }

  /// The buffer before *Test*: boxes, in records of two words where they go together.
  struct BoxQueue {
    BoxQueue(std::size_t entries, bool checked)
        : columns(2 * entries, "box columns", checked),
          row(entries, "box rows", checked),
          micropolygon(2 * entries, "box micropolygons", checked),
          samples(2 * entries, "box samples", checked) {}
    Buffer<float> columns, row;
    Buffer<std::int32_t> micropolygon, samples;
  };

  /// What is kept of each micropolygon of the packet beside its vertices.
  struct Held {
    Held(int micropolygons, bool checked)
        : size(micropolygons),
          inverse_area(entries(), "inverse areas", checked),
          equations(kPrecomputed ? entries() * kCoefficients : 1, "edge equations", checked),
          seen(entries()) {}
    std::size_t entries() const { return (static_cast<std::size_t>(size) + 63) / 64 * 64; }
    Memory<float> coefficients(int i) {
      return equations.memory().part(static_cast<std::size_t>(i) * entries(), entries());
    }

    int size;
    Buffer<float> inverse_area;
    Buffer<float> equations;
    std::vector<std::uint64_t> seen;  ///< Last observation of the working set that it was in.
    std::uint64_t observation = 0;
  };

  Vm& vm_;
  Cells cells_;
  RasterizerCounts& counts_;
  HitSink<Vm::kCounted>& sink_;
  int least_free_to_load_;                                           ///< Lanes.
  std::size_t entries_ = 2 * static_cast<std::size_t>(vm_.width());  ///< Of either buffer.
  BoxQueue queue_{entries_, vm_.checks()};
  int queued_ = 0;  ///< Entries of queue_.
  Buffer<std::int32_t> hit_queue_{2 * entries_, "hits", vm_.checks()};
  int hits_ = 0;  ///< Entries of hit_queue_: (micropolygon, sample).
  std::optional<Held> held_;
  WorkingSetCourse working_set_;
};

}  // namespace lanescope
