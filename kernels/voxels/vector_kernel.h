// SPDX-License-Identifier: MIT
// From a vector program, a template on the machine, to executions.
#pragma once

#include <memory>
#include <vector>

#include "kernels/kernel.h"
#include "kernels/voxels/counters.h"
#include "kernels/voxels/cube_images.h"
#include "kernels/voxels/options.h"
#include "kernels/voxels/or_into.h"
#include "kernels/voxels/probe_field.h"
#include "workloads/voxels/brick.h"

namespace lanescope {

/// Words of bits as programs address them, which shift them and do arithmetic with what they find.
inline Memory<const std::int32_t> words_of(const std::vector<std::uint32_t>& words,
                                           std::string_view name) {
  return read_only(reinterpret_cast<const std::int32_t*>(words.data()), words.size(), name);
}

/// A brick as programs address it. A probe's row is the first word of the row of cubes from which
/// the octant x, y, z >= 0 begins, and its bit the one of its first cube.
struct BrickMemory {
  explicit BrickMemory(const Brick& brick);

  Memory<const std::int32_t> rows() const { return words_of(brick->rows, "rows of cubes"); }
  Memory<const std::int32_t> probe_rows() const {
    return read_only(row.data(), row.size(), "rows of probes");
  }
  Memory<const std::int32_t> probe_bits() const {
    return read_only(bit.data(), bit.size(), "bits of probes");
  }
  int size() const { return static_cast<int>(row.size()); }

  const Brick* brick;
  std::vector<std::int32_t> row, bit;  ///< [probes]
};

/// The row of the first cubes of an octant, as words after the one of BrickMemory::row.
constexpr std::int32_t octant_start(int octant) {
  const auto step = [](bool falls, int row) { return falls ? -row : 0; };
  return step(octant & 2, Brick::row(1, 0)) + step(octant & 4, Brick::row(0, 1)) +
         (octant & 1 ? Brick::kBackward : Brick::kForward);
}

/// The rows of an octant in the order of octant_rows(), as words after the first one;
/// [octant][256], one after the other. They do not depend on the way along x.
const std::vector<std::int32_t>& octant_row_steps();

/// What a program is started with. The probes' floats are kHarmonics for each, in their order.
struct ProbeProgram {
  const SkySamples& samples;
  const CubeImages& cubes;
  const ProbeOptions& options;
};

/// The harmonics of a brick's probes in the output: of probe i, [kHarmonics * i + harmonic].
Memory<float> harmonics_of(ProbeField& field, const Brick& brick);

/// An execution of Program<Vm>, a class with
///   static constexpr std::size_t kStageCount;
///   Program(Vm&, const ProbeProgram&, ImageSink<Vm::kCounted>&);
///   void render(const BrickMemory&, Memory<float> harmonics);
template <template <class> class Program, class Vm>
class ProbeExecution final : public Execution {
 public:
  explicit ProbeExecution(const Launch& launch)
      : field_(static_cast<ProbeField&>(launch.output)),
        options_(probe_options(launch.arguments)),
        vm_(make_machine(launch)),
        program_(vm_,
                 {sky_samples(projection_of(launch.arguments)),
                  cube_images(projection_of(launch.arguments)), options_},
                 sink_) {}

  void run(const Work& work) override {
    const auto& brick = static_cast<const Brick&>(work);
    if constexpr (Vm::kCounted) sink_.counts[kProbes] += brick.probes.size();
    program_.render(BrickMemory(brick), harmonics_of(field_, brick));
  }

  KernelResult result() const override {
    KernelResult result;
    if constexpr (Vm::kCounted) result.counts = vm_.counts();
    result.counters.assign(sink_.counts.begin(), sink_.counts.end());
    result.results_hash = sink_.hash();
    return result;
  }

 private:
  static Vm make_machine(const Launch& launch) {
    constexpr std::size_t kStages = Program<Vm>::kStageCount;
    if constexpr (requires { Vm(launch.width, kStages, launch.mode, launch.observer); })
      return Vm(launch.width, kStages, launch.mode, launch.observer);
    else
      return Vm(launch.width, kStages);
  }

  ProbeField& field_;
  ProbeOptions options_;
  Vm vm_;
  ImageSink<Vm::kCounted> sink_;
  Program<Vm> program_;
};

/// Starts a program in one of the fast modes, on L lanes. Requires launch.width <= L.
template <template <class> class Program, int L>
std::unique_ptr<Execution> start_fast(const Launch& launch) {
  if (launch.mode == Mode::kCounting)
    return std::make_unique<ProbeExecution<Program, Machine<L, Mode::kCounting>>>(launch);
  return std::make_unique<ProbeExecution<Program, Machine<L, Mode::kUncounted>>>(launch);
}

/// Starts a program in one of the slow modes, on L lanes. Requires launch.width <= L.
template <template <class> class Program, int L>
std::unique_ptr<Execution> start_slow(const Launch& launch) {
  return std::make_unique<ProbeExecution<Program, SlowMachine<L>>>(launch);
}

}  // namespace lanescope
