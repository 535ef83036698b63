// SPDX-License-Identifier: MIT
#include "analysis/cli/narrated_experiment.h"

#include "analysis/cli/memory_notice.h"

namespace lanescope {

Report run_narrated(Narration& narration, const std::vector<Configuration>& configurations,
                    ExperimentOptions options) {
  tell_memory(configurations);
  options.opening = narration.listener();
  options.progress = [&](double fraction) { narration.update(fraction); };
  return run_experiment(configurations, options);
}

}  // namespace lanescope
