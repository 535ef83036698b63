// SPDX-License-Identifier: MIT
// From a vector program, a template on the machine, the shape and the edges, to executions: one
// instance for each combination, chosen at run time.
#pragma once

#include <memory>

#include "kernels/micropolygons/setup.h"

namespace lanescope {

/// What a vector program is started with.
struct ProgramOptions {
  KernelOptions kernel;
  Frame* frame;
};

/// The machine that a launch asks for. Requires one of Vm's modes.
template <class Vm>
Vm make_machine(const Launch& launch, std::size_t stage_count) {
  if constexpr (requires { Vm(launch.width, stage_count, launch.mode, launch.observer); })
    return Vm(launch.width, stage_count, launch.mode, launch.observer);
  else
    return Vm(launch.width, stage_count);
}

/// An execution of Program<Vm, P, E>, a class with
///   static constexpr std::size_t kStageCount, kCounterCount;
///   Program(Vm&, const ProgramOptions&, RasterizerCounts&, HitSink<Vm::kCounted>&);
///   void rasterize(const PacketMemory<P>&, int size, std::uint64_t first_id);
/// and, if its kernel has series, `std::vector<std::vector<std::uint64_t>> series() const`.
template <template <class, Micropolygon, Edges> class Program, class Vm, Micropolygon P, Edges E>
class ProgramExecution final : public Execution {
 public:
  explicit ProgramExecution(const Launch& launch)
      : options_(launch.options),
        vm_(make_machine<Vm>(launch, Program<Vm, P, E>::kStageCount)),
        sink_(launch.frame, counts_),
        program_(vm_, {launch.options, &launch.frame}, counts_, sink_) {}

  void rasterize(const Packet& packet) override {
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
    result.counts = vm_.counts();
    result.counters.assign(counts_.begin(), counts_.begin() + Program<Vm, P, E>::kCounterCount);
    if constexpr (requires { program_.series(); }) result.series = program_.series();
    result.hits_hash = sink_.hits_hash();
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
  const auto with_edges = [&]<Micropolygon P>() -> std::unique_ptr<Execution> {
    if (launch.options.edges == Edges::kInline)
      return std::make_unique<ProgramExecution<Program, Vm, P, Edges::kInline>>(launch);
    return std::make_unique<ProgramExecution<Program, Vm, P, Edges::kPrecomputed>>(launch);
  };
  return launch.options.shape == Micropolygon::kTriangle
             ? with_edges.template operator()<Micropolygon::kTriangle>()
             : with_edges.template operator()<Micropolygon::kQuad>();
}

/// Starts a program in one of the fast modes, on L lanes. Requires launch.width <= L.
template <template <class, Micropolygon, Edges> class Program, int L>
std::unique_ptr<Execution> start_fast(const Launch& launch) {
  return launch.mode == Mode::kCounting
             ? start_on<Program, Machine<L, Mode::kCounting>>(launch)
             : start_on<Program, Machine<L, Mode::kUncounted>>(launch);
}

/// Starts a program in one of the slow modes, on L lanes. Requires launch.width <= L.
template <template <class, Micropolygon, Edges> class Program, int L>
std::unique_ptr<Execution> start_slow(const Launch& launch) {
  return start_on<Program, SlowMachine<L>>(launch);
}

}  // namespace lanescope
