// SPDX-License-Identifier: MIT
// A report with all scenes of the study, so that it can be compared with the thesis.
#pragma once

#include <string_view>
#include <utility>

#include "tests/analysis/sample_report.h"

namespace lanescope::luong {

/// The sample report with the other two scenes, which are as the first two: means are those of two.
inline Report sample_of_study() {
  constexpr std::pair<std::string_view, const char*> kAlike[] = {{"ballroll", "tigerjump"},
                                                                 {"columnpivot", "talking"}};
  Report all = testing::sample_report();
  for (const auto& [scene, other] : kAlike)
    for (std::size_t i = 0, runs = all.runs.size(); i < runs; ++i)
      if (all.runs[i].configuration.scene == scene) {
        RunRecord copy = all.runs[i];
        copy.configuration.scene = other;
        all.runs.push_back(std::move(copy));
      }
  return all;
}

}  // namespace lanescope::luong
