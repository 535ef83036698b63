// SPDX-License-Identifier: MIT
// The JSON form of what one start of a sweep did.
#pragma once

#include <string>

#include "analysis/sweep/sweep.h"

namespace lanescope {

/// The summary as a document.
std::string summary_text(const SweepSummary& summary);

}  // namespace lanescope
