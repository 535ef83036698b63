// SPDX-License-Identifier: MIT
// Reports taken apart into runs and put together again.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// One run of a report as a report of its own, with the instructions that it issued. Times that
/// belong to the whole report are shared out evenly among its runs. Its `command` is the report's.
Report single_run(const Report& report, std::size_t run);

/// One report with the runs of all. They are in a fixed order, whatever order they come in: by kind
/// of work, scene and setting, then by facet, kernel and width, as `lanescope run` lists them; see
/// analysis/report/run_order.h. A run that several reports have is taken once. Times are summed,
/// the largest peak of memory is kept; `command` is left to the caller.
/// Throws InputError, naming both reports, if they come from different versions of the program, if
/// they explain an instruction differently, or if a run of the same parameters has different
/// counts. Requires at least one report.
Report merge_reports(const std::vector<NamedReport>& reports);

}  // namespace lanescope
