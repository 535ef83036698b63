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

#include "kernels/micropolygons/steps.h"
#include "kernels/micropolygons/vector_kernel.h"

namespace lanescope {

/// In the order of Repack::Stage.
inline constexpr std::array<std::string_view, 5> kRepackStages{"Setup", "Bound", "Test Stream-load",
                                                               "Test", "Process"};

/// With the steps of `Steps`, which see in steps.h.
template <class Vm, Micropolygon P, Edges E, class Steps>
class BasicRepack {
 public:
  enum Stage : std::size_t { kSetup, kBound, kStreamLoad, kTest, kProcess };
  static constexpr std::size_t kStageCount = kRepackStages.size();
  static_assert(kProcess + 1 == kStageCount, "a stage has no name, or a name no stage");
  static constexpr std::size_t kCounterCount = kRasterizerCounterCount;

  BasicRepack(Vm& vm, const ProgramOptions& options, RasterizerCounts& counts,
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
        process(sites, packet, first_id);
      } else if (testable >= width || (!input_left && testable > 0)) {
        const int busy = lanes.busy.count();
        if (queued_ > 0 && (width - busy >= least_free_to_load_ || busy == 0))
          stream_load(sites, lanes, busy);
        test(sites, packet, lanes);
      } else if (input_left) {
        const bool bounded = bound_batch(sites, packet, next, vm_.first_n(size - next));
        if (Vm::kCounted && bounded) observe_working_set(lanes);
        next += width;
      } else if (hits_ > 0) {
        process(sites, packet, first_id);
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
  using Compaction = typename Steps::Compaction;
  using EdgeTest = typename Steps::EdgeTest;
  using Carried = typename Steps::Carried;
  using FrameAccess = typename Steps::FrameAccess;
  using HitBatch = typename Steps::HitBatch;
  static_assert(Carried::kWords == 0 ||
                    (EdgeTest::kGivesValues && std::is_same_v<HitBatch, HitsOnTop>),
                "only values that Test gives can be carried, by hits that stay in order");
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
          processing(vm.site(kProcess)),
          choosing(vm, kProcess),
          merging(vm, kProcess) {}
    typename Vm::Site setup, bounding, queueing, ranking, loading, testing, regathering, ruling,
        compacting, storing, processing;
    typename HitBatch::template Sites<Vm> choosing;
    typename FrameAccess::template Sites<Vm> merging;
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
    Int micropolygon;
    const auto place = [&] LANESCOPE_INLINE_LAMBDA {
      auto on = sites.bounding.on(batch.alive);
      auto extra = on.overhead();
      box = bound<Vm, P>(on, batch.positions, cells_);
      if constexpr (kTriangles)
        store(extra, held_->inverse_area.memory(), first, rcp(on, batch.area));
      if constexpr (kPrecomputed)
        store_equations(extra, edge_equations<Vm, P>(on, batch.positions, batch.area), first);
      with_candidates = cmp_gt(on, box.candidates, 0);
      const auto behind = Compaction::places_behind(extra, with_candidates, queued_);
      micropolygon = add(extra, lane_index(extra), first);
      queued_ += count(extra, with_candidates);
      return behind;
    }();
    auto on = sites.queueing.on(with_candidates);
    auto extra = on.overhead();
    Compaction::push(extra, queue_.columns.memory(), place, box.first_column, box.last_column);
    Compaction::push(extra, queue_.row.memory(), place, box.first_row);
    Compaction::push(extra, queue_.micropolygon.memory(), place, micropolygon, box.candidates);
    Compaction::push(extra, queue_.samples.memory(), place, box.first_sample, box.row_step);
    if constexpr (Vm::kCounted) count_boxes(counts_, box, batch.alive, with_candidates);
    return true;
  }

  /// *Test Stream-load*: free lanes take boxes from the queue.
  LANESCOPE_INLINE void stream_load(Sites& sites, TestLanes& lanes, int busy) {
    const Lanes free = vm_.all() & ~lanes.busy;
    const auto taken = [&] LANESCOPE_INLINE_LAMBDA {
      auto on = sites.ranking.on(free);
      auto extra = on.overhead();
      return Compaction::take(extra, free, vm_.width() - busy, queued_);
    }();
    auto on = sites.loading.on(taken.lanes);
    auto extra = on.overhead();
    const auto pop = [&](auto buffer, const auto&... rest) LANESCOPE_INLINE_LAMBDA {
      return Compaction::pop(extra, buffer, taken.places, rest...);
    };
    std::tie(lanes.first_column, lanes.last_column) =
        pop(queue_.columns.memory(), lanes.first_column, lanes.last_column);
    lanes.at.column = move(extra, lanes.first_column, lanes.at.column);
    lanes.at.row = pop(queue_.row.memory(), lanes.at.row);
    std::tie(lanes.micropolygon, lanes.remaining) =
        pop(queue_.micropolygon.memory(), lanes.micropolygon, lanes.remaining);
    std::tie(lanes.at.sample, lanes.row_step) =
        pop(queue_.samples.memory(), lanes.at.sample, lanes.row_step);
    queued_ -= taken.lanes.count();
    lanes.busy = lanes.busy | taken.lanes;
  }

  /// *Test*: one candidate of each busy lane; hits are pushed to the queue of *Process*.
  LANESCOPE_INLINE void test(Sites& sites, const PacketMemory<P>& packet, TestLanes& lanes) {
    const Lanes active = lanes.busy;
    const Int sample = lanes.at.sample;
    Float px, py;
    Coverage<Vm> coverage;
    Positions<Vm, P> positions;
    EdgeValues<Vm, P> values;
    {
      auto on = sites.testing.on(active);
      auto extra = on.overhead();
      std::tie(px, py) = place_sample<Vm>(on, lanes.at.column, lanes.at.row, sample, cells_);
      if constexpr (kPrecomputed) {
        values = gathered_edges(extra, on, packet, lanes.micropolygon, px, py);
        coverage = point_in_polygon<Vm, P>(on, values);
      } else {
        positions = gather_positions(extra, packet, lanes.micropolygon);
        coverage = EdgeTest::template test<Vm, P>(on, positions, px, py, values);
      }
      lanes.at = advance<Vm>(on, lanes.at, lanes.first_column, lanes.last_column, lanes.row_step);
      lanes.remaining = sub(extra, lanes.remaining, 1);
      lanes.busy = cmp_gt(on, lanes.remaining, 0);
    }
    if (coverage.any_on_edge) [[unlikely]] {
      if constexpr (kPrecomputed) {
        auto on = sites.regathering.on(coverage.on_edge);
        positions = gather_positions(on.overhead(), packet, lanes.micropolygon);
      } else if constexpr (!EdgeTest::kGivesValues) {
        auto on = sites.regathering.on(coverage.on_edge);
        values = inline_edges<Vm, P>(on, positions, px, py);
      }
      add_owned_samples<Vm, P>(sites.ruling, coverage, positions, values);
    }
    if (coverage.any_inside)
      compact(sites, active, coverage.inside, lanes.micropolygon, sample, values);
  }

  LANESCOPE_INLINE void compact(Sites& sites, Lanes active, Lanes hits, const Int& micropolygon,
                                const Int& sample, const EdgeValues<Vm, P>& values) {
    int hit_count;
    const auto place = [&] LANESCOPE_INLINE_LAMBDA {
      auto on = sites.compacting.on(active);
      auto extra = on.overhead();
      const auto behind = Compaction::places_behind(extra, hits, hits_);
      hit_count = count(extra, hits);
      return behind;
    }();
    auto on = sites.storing.on(hits);
    auto extra = on.overhead();
    Compaction::push(extra, hit_queue_.memory(), place, micropolygon, sample);
    if constexpr (Carried::kWords > 0) Carried::push(extra, carried_.memory(), place, values);
    hits_ += hit_count;
  }

  /// *Process* of a batch of hits from the queue.
  LANESCOPE_INLINE void process(Sites& sites, const PacketMemory<P>& packet,
                                std::uint64_t first_id) {
    const auto batch = HitBatch::take(vm_, sites.choosing, hit_queue_.memory(), hits_);
    auto on = sites.processing.on(batch.lanes);
    auto extra = on.overhead();
    const auto [micropolygon, sample] = batch.load(extra, hit_queue_.memory());
    EdgeValues<Vm, P> values;
    if constexpr (Carried::kWords > 0)
      values = Carried::template load<Vm, P>(extra, carried_.memory(), batch.first);
    else
      values = edges_again(extra, packet, micropolygon, sample);
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
    FrameAccess::merge(sites.merging, on, Hits{sink_, first_id}, micropolygon, sample, shade[0],
                       shade[1], shade[2], shade[3], shade[4]);
  }

  /// Edge functions of hits, from micropolygon and sample. At full utilization that costs less than
  /// passing them through the queue under the mask of hits.
  template <class Extra>
  LANESCOPE_INLINE EdgeValues<Vm, P> edges_again(Extra& extra, const PacketMemory<P>& packet,
                                                 const Int& micropolygon, const Int& sample) {
    const auto row = div(extra, sample, cells_.stride);
    const auto column = sub(extra, sample, mul(extra, row, cells_.stride));
    const auto [px, py] = place_sample<Vm>(extra, convert_to_float(extra, column),
                                           convert_to_float(extra, row), sample, cells_);
    return gathered_edges(extra, extra, packet, micropolygon, px, py);
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
                                                    const Float& py) {
    if constexpr (kPrecomputed) {
      const auto x = gather(extra, packet.x(0), micropolygon);
      const auto y = gather(extra, packet.y(0), micropolygon);
      return precomputed_edges<Vm, P>(on, gather_equations(extra, micropolygon), x, y, px, py);
    } else {
      const auto positions = gather_positions(extra, packet, micropolygon);
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
  Buffer<float> carried_{std::max<std::size_t>(1, Carried::kWords* entries_), "carried values",
                         vm_.checks()};
  std::optional<Held> held_;
  WorkingSetCourse working_set_;
};

/// As the thesis has it.
template <class Vm, Micropolygon P, Edges E>
using Repack = BasicRepack<Vm, P, E, PlainSteps>;

}  // namespace lanescope
