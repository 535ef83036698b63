// SPDX-License-Identifier: MIT
// The order of runs that came from different reports.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// A part of what decides the place of a run. Numbers of either type compare by value, for which a
/// long double holds all of both.
using Rank = std::variant<std::monostate, bool, long double, std::string>;

/// What runs are ordered by, the first difference deciding: kind of work, scene, setting (the other
/// parameters of the kind of work, mode, observe_every), facet, kernel, the kernel's parameters,
/// width. Kinds, scenes, kernels and the words of a parameter are in the order of their lists;
/// those that this program does not know come after, by name.
std::vector<Rank> place_of(const RunRecord& run);

}  // namespace lanescope
