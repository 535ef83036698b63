// SPDX-License-Identifier: MIT
// Runs of kernels on packets, as the kernel tests compare them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kernels/kernel.h"
#include "kernels/micropolygons/frame.h"
#include "kernels/micropolygons/options.h"
#include "tests/kernels/tried_widths.h"
#include "workloads/micropolygons/micropolygon.h"

namespace lanescope::test {

/// The kernels of this kind of work.
std::vector<const Kernel*> rasterizers();

/// What a kernel made of some packets.
struct Outcome {
  KernelResult result;
  std::uint64_t frame_hash;

  /// A counter of the kernel by name.
  std::uint64_t counter(const Kernel& kernel, std::string_view name) const;
};

/// What a kernel is started with for packets of a shape.
Arguments arguments_of(const KernelOptions& options, Micropolygon shape);

/// Runs a kernel over packets of one shape on one execution. A tracing machine is watched by
/// nobody. Requires a packet.
Outcome run(const Kernel& kernel, int width, Mode mode, const KernelOptions& options,
            const SampleGrid& grid, const std::vector<const Packet*>& packets);

/// A packet of polygons given by the positions of their corners; depth 1, white.
Packet packet_of(Micropolygon shape,
                 const std::vector<std::vector<std::pair<float, float>>>& polygons);

/// Squares of side `size`, side by side from the origin, `columns` in each of `rows` rows.
Packet squares(int columns, int rows, float size);

/// Expects the hits, the frame and the shared counters of the reference.
void expect_same(const Kernel& kernel, const Outcome& outcome, const Outcome& reference);

/// Expects every kernel, in every mode, at the widths that it has of these and with both kinds of
/// edges, to agree with the reference on the packet. Of corners that no source emits checked mode
/// may report that they overflow.
void expect_agreement(const Packet& packet, const SampleGrid& grid, bool cull_backfaces,
                      const std::vector<int>& widths);

}  // namespace lanescope::test
