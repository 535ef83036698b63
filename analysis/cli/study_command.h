// SPDX-License-Identifier: MIT
// A study as a command: its experiment and its tables, from a new run or from a report.
#pragma once

#include "analysis/cli/options.h"
#include "analysis/studies/study.h"

namespace lanescope {

/// Declares the options of a study and returns what runs it.
Action declare_study(CommandOptions& options, const Study& study);

}  // namespace lanescope
