// SPDX-License-Identifier: MIT
// Runs of several reports, pooled, and taken apart again into those that can be compared.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// Runs of one setting: they differ in kernel, width, facet and scene only.
struct Group {
  std::string name;   ///< The parameters that tell groups apart: `samples_per_pixel = 4`; or empty.
  Arguments setting;  ///< The same with their values.
  Report report;      ///< These runs and their times, with the instructions of all sources.
};

/// All runs, by setting, in the order in which settings first occur. Settings are the kind of work
/// and all parameters but kernel, width, scene and facet. A run whose kernel does not take a
/// parameter is of every setting of it, so that it can be compared with each. What the scene
/// decides makes no setting, unless one scene is there at several. Throws InputError if two files
/// have the same run.
std::vector<Group> groups_of(const std::vector<NamedReport>& sources);

}  // namespace lanescope
