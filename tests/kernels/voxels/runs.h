// SPDX-License-Identifier: MIT
// Runs of voxel kernels on bricks, as their tests compare them.
#pragma once

#include <vector>

#include "kernels/kernel.h"
#include "kernels/voxels/probe_field.h"
#include "tests/kernels/tried_widths.h"
#include "workloads/voxels/brick.h"
#include "workloads/voxels/options.h"

namespace lanescope::test {

/// One probe or place of so many is tried: all, but where the sanitizers look for faults of memory,
/// for which some do, at twenty times the time.
#ifdef __SANITIZE_ADDRESS__
inline constexpr int kTriedEvery = 7;
#else
inline constexpr int kTriedEvery = 1;
#endif

/// The vector programs of this kind of work.
std::vector<const Kernel*> voxel_programs();

/// What a kernel made of some bricks.
struct Rendered {
  KernelResult result;
  std::vector<Harmonics> probes;

  /// A counter of the kernel by name.
  std::uint64_t counter(const Kernel& kernel, std::string_view name) const;
};

/// Runs a kernel over bricks on one execution. A tracing machine is watched by an observer that
/// counts.
Rendered render(const Kernel& kernel, int width, Mode mode, SkyProjection projection,
                const std::vector<Brick>& bricks);

/// The bricks of a world, with every `step`-th of their probes.
std::vector<Brick> bricks_of(const World& world, std::size_t step, int levels = 1);

/// Expects the images of the reference, bit for bit, its counters, and its harmonics as near as
/// sums of floats can be.
void expect_same(const Kernel& kernel, const Rendered& rendered, const Rendered& reference);

/// Expects every program, in these modes at these widths, to agree with the reference.
void expect_agreement(const std::vector<Brick>& bricks, SkyProjection projection,
                      const std::vector<Mode>& modes, const std::vector<int>& widths);

}  // namespace lanescope::test
