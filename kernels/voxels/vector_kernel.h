// SPDX-License-Identifier: MIT
// From a vector program, a template on the machine, to executions.
#pragma once

#include <memory>
#include <vector>

#include "kernels/kernel.h"
#include "kernels/make_machine.h"
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

/// What probes see of a brick in one go: cubes, or beyond them megacubes. In either case an octant
/// is 16 x 16 rows of 16, and the images are the same.
struct Level {
  /// The first word of the rows that begin at each probe, and its bit there, for octants in which
  /// nothing falls; [probes].
  std::vector<std::int32_t> row, bit;
  std::int32_t turned_bit;                   ///< Minus the bit, if x falls.
  std::array<std::int32_t, kOctants> start;  ///< From the first word to that of each octant.
  /// [octant][kOctantRows] From there to each row, in the order of octant_rows().
  const std::vector<std::int32_t>* steps;
  /// [kOctantRows] Of each row, those that count: megacubes within reach do not.
  const std::vector<std::int32_t>* row_bits;
};

/// A brick as programs address it.
struct BrickMemory {
  explicit BrickMemory(const Brick& brick);

  Memory<const std::int32_t> rows() const { return words_of(brick->rows, "rows of cubes"); }
  int size() const { return static_cast<int>(brick->probes.size()); }

  const Brick* brick;
  std::vector<Level> levels;  ///< The nearest first.
};

/// A list of a level as programs address it.
inline Memory<const std::int32_t> memory_of(const std::vector<std::int32_t>& list,
                                            std::string_view name) {
  return read_only(list.data(), list.size(), name);
}

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
        vm_(make_machine<Vm>(launch, Program<Vm>::kStageCount)),
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
