// SPDX-License-Identifier: MIT
// Runs of a report that the options of an experiment ask for.
#pragma once

#include <string>

#include "analysis/cli/experiment_arguments.h"
#include "analysis/report/report.h"

namespace lanescope {

/// The report with those of its runs that have one of the values of every option that was given.
/// Throws InputError for an option that selects none of what the options before it have left,
/// naming what would have.
Report selected(NamedReport source, const ExperimentArguments& arguments);

}  // namespace lanescope
