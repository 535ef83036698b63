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

/// A run of a kernel at W = 8 on a scene that is like the thesis's.
RunRecord sample_run(const std::string& kernel, const std::string& scene, Micropolygon shape,
                     const std::vector<SampleStage>& stages, std::uint64_t rasterized);

/// LOCKSTEP and REPACK at W = 8 on triangles and quads of two scenes, `first` and `second`:
///
///   lockstep, triangles   first: issued/active    second
///   Setup                  2 /  16                 3 /  12
///   Bound                 10 /  72                20 / 128
///   Test                  60 / 360                60 / 240
///   Process               30 /  60                20 /  80
///   rasterized            20                      10
///
/// and on `third`, which is not like the thesis's. Quads issue 8/10 of the instructions (all of
/// Setup's) for half of the micropolygons.
Report sample_report();

}  // namespace lanescope::testing
