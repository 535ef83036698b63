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

/// An execution of Program<Vm, P, E>, a class with
///   static constexpr std::size_t kStageCount, kCounterCount;
///   Program(Vm&, const ProgramOptions&, RasterizerCounts&, HitSink&);
///   void rasterize(const PacketMemory<P>&, int size, std::uint64_t first_id);
/// and, if its kernel has series, `std::vector<std::vector<std::uint64_t>> series() const`.
template <template <class, Micropolygon, Edges> class Program, class Vm, Micropolygon P, Edges E>
class ProgramExecution final : public Execution {
 public:
  explicit ProgramExecution(const Launch& launch)
      : options_(launch.options),
        vm_(Program<Vm, P, E>::kStageCount, launch.observer),
        sink_{&launch.frame, Vm::kMode != Mode::kUncounted, &counts_},
        program_(vm_, {launch.options, &launch.frame}, counts_, sink_) {}

  void rasterize(const Packet& packet) override {
    if (options_.cull_backfaces) {
      program_.rasterize(PacketMemory<P>(packet), packet.size(), packet.first_id);
      return;
    }
    TurnedPacket<Vm, P> turned(packet, Vm::kCheckedMode);
    for (int first = 0; first < packet.size(); first += Vm::kWidth)
      turned.turn(vm_, kSetupStage, first, Vm::Lanes::first_n(packet.size() - first));
    program_.rasterize(turned.memory(), packet.size(), packet.first_id);
  }

  KernelResult result() const override {
    KernelResult result;
    result.counts = vm_.counts();
    result.counters.assign(counts_.begin(), counts_.begin() + Program<Vm, P, E>::kCounterCount);
    if constexpr (requires { program_.series(); }) result.series = program_.series();
    result.hits_hash = sink_.hits_hash;
    return result;
  }

 private:
  static constexpr std::size_t kSetupStage = 0;

  KernelOptions options_;
  Vm vm_;
  RasterizerCounts counts_{};
  HitSink sink_;
  Program<Vm, P, E> program_;
};

/// Starts a program on a machine of width W.
template <template <class, Micropolygon, Edges> class Program, int W>
std::unique_ptr<Execution> start_program(const Launch& launch) {
  const auto with_edges = [&]<Mode M, Micropolygon P>() -> std::unique_ptr<Execution> {
    using Vm = Machine<W, M>;
    if (launch.options.edges == Edges::kInline)
      return std::make_unique<ProgramExecution<Program, Vm, P, Edges::kInline>>(launch);
    return std::make_unique<ProgramExecution<Program, Vm, P, Edges::kPrecomputed>>(launch);
  };
  const auto with_shape = [&]<Mode M>() {
    return launch.options.shape == Micropolygon::kTriangle
               ? with_edges.template operator()<M, Micropolygon::kTriangle>()
               : with_edges.template operator()<M, Micropolygon::kQuad>();
  };
  switch (launch.mode) {
    case Mode::kCounting:
      return with_shape.template operator()<Mode::kCounting>();
    case Mode::kChecked:
      return with_shape.template operator()<Mode::kChecked>();
    case Mode::kTracing:
      return with_shape.template operator()<Mode::kTracing>();
    case Mode::kUncounted:
      return with_shape.template operator()<Mode::kUncounted>();
  }
  return nullptr;
}

}  // namespace lanescope
