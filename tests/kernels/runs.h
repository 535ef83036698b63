// SPDX-License-Identifier: MIT
// Runs of kernels on packets, as the kernel tests compare them.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "kernels/kernel.h"

namespace lanescope::test {

/// What a kernel made of some packets.
struct Outcome {
  KernelResult result;
  std::uint64_t frame_hash;

  /// A counter of the kernel by name.
  std::uint64_t counter(const Kernel& kernel, std::string_view name) const;
};

/// Runs a kernel over packets on one execution.
Outcome run(const Kernel& kernel, int width, Mode mode, const KernelOptions& options,
            const SampleGrid& grid, const std::vector<const Packet*>& packets);

/// A packet of polygons given by the positions of their corners; depth 1, white.
Packet packet_of(Micropolygon shape,
                 const std::vector<std::vector<std::pair<float, float>>>& polygons);

/// Squares of side `size`, side by side from the origin, `columns` in each of `rows` rows.
Packet squares(int columns, int rows, float size);

/// Expects the hits, the frame and the shared counters of the reference.
void expect_same(const Kernel& kernel, const Outcome& outcome, const Outcome& reference);

/// Expects every kernel, at every width and with both kinds of edges, to agree with the reference
/// on the packet; in counting mode, or in all modes.
void expect_agreement(const Packet& packet, const SampleGrid& grid, bool cull_backfaces,
                      std::initializer_list<Mode> modes);

}  // namespace lanescope::test
