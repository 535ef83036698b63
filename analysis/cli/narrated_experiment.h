// SPDX-License-Identifier: MIT
// An experiment as commands run it.
#pragma once

#include <vector>

#include "analysis/cli/narration.h"
#include "analysis/experiment/experiment.h"

namespace lanescope {

/// As run_experiment(), with the memory that it takes and how it goes told in a narration, which
/// `options` leave room for.
Report run_narrated(Narration& narration, const std::vector<Configuration>& configurations,
                    ExperimentOptions options);

}  // namespace lanescope
