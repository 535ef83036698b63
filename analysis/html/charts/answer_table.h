// SPDX-License-Identifier: MIT
// What a reader wants to know first: which kernel is ahead where, and how busy its lanes are.
#pragma once

#include <string>
#include <vector>

#include "analysis/html/section.h"
#include "analysis/report/figures.h"

namespace lanescope {

/// A list of sentences, as the page shows what was found; empty without any.
Markup findings(const std::vector<std::string>& sentences);

/// Sentences about the narrowest and the widest machine, for each facet: what each kernel needs,
/// the cheapest first. None if nothing was counted.
std::vector<std::string> ranking_sentences(const ReportView& view, Stages stages);

/// For each scene, and the mean of several, and each W (powers of two if there are many): the
/// kernel that issues the fewest instructions of `stages` for each element, how many, and its
/// utilization. Kernels that were not run on all scenes have no part in the mean, which a note
/// says. `note` defines the figures; a sentence or two. Empty if nothing was counted.
Markup answer_table(const ReportView& view, Stages stages, const std::string& note);

/// `7% fewer`, `3% more` or `as many`, of a part against a whole: of instructions.
std::string shown_change(double part, double whole);

}  // namespace lanescope
