// SPDX-License-Identifier: MIT
#include "analysis/experiment/width_independence.h"

#include <algorithm>

#include "simulator/check.h"

namespace lanescope {
namespace {

bool differ_in_width_alone(const Configuration& a, const Configuration& b) {
  Configuration as_wide = a;
  as_wide.width = b.width;
  return as_wide == b;
}

}  // namespace

void require_width_independence(std::span<const RunRecord> runs) {
  for (auto run = runs.begin(); run != runs.end(); ++run) {
    const Configuration& c = run->configuration;
    if (c.mode != Mode::kChecked) continue;
    const auto other = std::find_if(runs.begin(), run, [&](const RunRecord& earlier) {
      return earlier.results_hash != run->results_hash &&
             differ_in_width_alone(earlier.configuration, c);
    });
    if (other == run) continue;
    throw FailedCheck(Check::kWidth,
                      fmt::format("{} on {}: its results at W = {} are not those at W = {}",
                                  c.kernel, c.scene, c.width, other->configuration.width));
  }
}

}  // namespace lanescope
