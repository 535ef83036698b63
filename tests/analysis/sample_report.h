// SPDX-License-Identifier: MIT
// A small report made by hand, so that tests can compute what tables must show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope::testing {

/// A stage that issued `add`, and if it is Process also one `scatter`, which is observed. Requires
/// `active` of at most 8 lanes for each instruction.
struct SampleStage {
  std::string name;
  std::uint64_t issued;
  std::uint64_t active;
  std::uint64_t overhead_issued = 0;
};

/// A run of a kernel at W = 8 on frame 0 of a scene, all else by default. `micropolygon` is
/// `triangle` or `quad`.
RunRecord sample_run(const std::string& kernel, const std::string& scene,
                     const std::string& micropolygon, const std::vector<SampleStage>& stages,
                     std::uint64_t rasterized);

/// LOCKSTEP and REPACK at W = 8 on triangles and quads of two scenes of the thesis:
///
///   lockstep, triangles   ballroll: issued/active   columnpivot
///   Setup                  2 /  16                   3 /  12
///   Bound                 10 /  72                  20 / 128
///   Test                  60 / 360                  60 / 240
///   Process               30 /  60                  20 /  80
///   rasterized            20                        10
///
/// and of the teapot, which is not among the thesis's. Quads issue 8/10 of the instructions (all of
/// Setup's) for half of the micropolygons.
Report sample_report();

}  // namespace lanescope::testing
