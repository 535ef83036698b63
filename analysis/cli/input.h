// SPDX-License-Identifier: MIT
// Reports that are named on the command line.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// Reads the reports in these files, in their order, each named as its file, with what cannot be
/// shown of its name escaped. Throws InputError for the first that cannot be read or is no report.
std::vector<NamedReport> read_reports(const std::vector<std::string>& files);

}  // namespace lanescope
