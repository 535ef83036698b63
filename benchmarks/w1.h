// SPDX-License-Identifier: MIT
// W1: a lockstep loop of point-in-triangle tests, the workload on which the cost of counting is
// measured: triangles of about half a pixel at 4 samples a pixel, W at a time, each tested against
// the first of the samples of a 4 x 4 stamp.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/instruction_set.h"

namespace lanescope::w1 {

/// Samples of the stamp.
inline constexpr int kSamples = 16;
extern const float kSampleX[kSamples];
extern const float kSampleY[kSamples];

/// Triangles in structure-of-arrays form; vertices in samples, relative to the stamp. Triangle i is
/// tested against its first tests[i] samples of the stamp.
struct Triangles {
  std::vector<float> x[3], y[3];
  std::vector<std::int32_t> tests;
  std::vector<std::uint32_t> hits;  ///< Output: bit s is set where sample s is covered.

  int size() const { return static_cast<int>(tests.size()); }
};

/// Reproducible triangles. Requires count % 64 == 0.
Triangles make_triangles(int count);

/// The work in AVX-512 intrinsics, W lanes at a time. Only on hosts that have it.
template <int W>
void run_by_hand(Triangles& triangles);

/// The same as a program of the machine. Returns what it counted.
template <int W, Mode M>
Counts run_on_machine(Triangles& triangles);

}  // namespace lanescope::w1
