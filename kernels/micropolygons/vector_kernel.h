// SPDX-License-Identifier: MIT
// From a vector program, a template on the machine, the shape and the edges, to executions: one
// instance for each combination, chosen at run time.
#pragma once

#include <memory>

#include "kernels/kernel.h"
#include "kernels/make_machine.h"
#include "kernels/micropolygons/options.h"
#include "kernels/micropolygons/setup.h"

namespace lanescope {

/// What a vector program is started with.
struct ProgramOptions {
  KernelOptions kernel;
  Frame* frame;
};

/// An execution of Program<Vm, P, E>, a class with
///   static constexpr std::size_t kStageCount, kCounterCount;
///   Program(Vm&, const ProgramOptions&, RasterizerCounts&, HitSink<Vm::kCounted>&);
///   void rasterize(const PacketMemory<P>&, int size, std::uint64_t first_id);
/// and, if its kernel has series, `std::vector<std::vector<std::uint64_t>> series() const`.
template <template <class, Micropolygon, Edges> class Program, class Vm, Micropolygon P, Edges E>
class ProgramExecution final : public Execution {
 public:
  ProgramExecution(const Launch& launch, const KernelOptions& options)
      : options_(options),
        vm_(make_machine<Vm>(launch, Program<Vm, P, E>::kStageCount)),
        sink_(static_cast<Frame&>(launch.output), counts_),
        program_(vm_, {options, &static_cast<Frame&>(launch.output)}, counts_, sink_) {}

  void run(const Work& work) override {
    const auto& packet = static_cast<const Packet&>(work);
    if (options_.cull_backfaces) {
      program_.rasterize(PacketMemory<P>(packet), packet.size(), packet.first_id);
      return;
    }
    TurnedPacket<Vm, P> turned(packet, vm_.checks());
    turned.turn(vm_, kSetupStage, packet.size());
    program_.rasterize(turned.memory(), packet.size(), packet.first_id);
  }

  KernelResult result() const override {
    KernelResult result;
    if constexpr (Vm::kCounted) result.counts = vm_.counts();
    result.counters.assign(counts_.begin(), counts_.begin() + Program<Vm, P, E>::kCounterCount);
    if constexpr (requires { program_.series(); }) result.series = program_.series();
    result.results_hash = sink_.hits_hash();
    return result;
  }

 private:
  static constexpr std::size_t kSetupStage = 0;

  KernelOptions options_;
  Vm vm_;
  RasterizerCounts counts_{};
  HitSink<Vm::kCounted> sink_;
  Program<Vm, P, E> program_;
};

/// Starts a program on a machine of this kind.
template <template <class, Micropolygon, Edges> class Program, class Vm>
std::unique_ptr<Execution> start_on(const Launch& launch) {
  const KernelOptions options = kernel_options(launch.arguments);
  const auto with_edges = [&]<Micropolygon P>() -> std::unique_ptr<Execution> {
    if (options.edges == Edges::kInline)
      return std::make_unique<ProgramExecution<Program, Vm, P, Edges::kInline>>(launch, options);
    return std::make_unique<ProgramExecution<Program, Vm, P, Edges::kPrecomputed>>(launch, options);
  };
  return shape_of(launch.arguments) == Micropolygon::kTriangle
             ? with_edges.template operator()<Micropolygon::kTriangle>()
             : with_edges.template operator()<Micropolygon::kQuad>();
}

/// Starts a program in one of the fast modes, on L lanes. Requires launch.width <= L.
template <template <class, Micropolygon, Edges> class Program, int L>
std::unique_ptr<Execution> start_fast(const Launch& launch) {
  return launch.mode == Mode::kCounting ? start_on<Program, Machine<L, Mode::kCounting>>(launch)
                                        : start_on<Program, Machine<L, Mode::kUncounted>>(launch);
}

/// Starts a program in one of the slow modes, on L lanes. Requires launch.width <= L.
template <template <class, Micropolygon, Edges> class Program, int L>
std::unique_ptr<Execution> start_slow(const Launch& launch) {
  return start_on<Program, SlowMachine<L>>(launch);
}

}  // namespace lanescope
