// SPDX-License-Identifier: MIT
// Draws something else of a kernel's work than its output.
#pragma once

#include <functional>
#include <memory>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// The output of a view on the work of a configuration, whatever its width and mode. `progress` is
/// called with the finished share of the work, from 0 to 1, on the caller's thread. Throws
/// InputError for what the configuration names and does not exist. Requires a view of the
/// configuration's kernel or of another of its kind, and threads > 0.
std::unique_ptr<Output> draw(const Configuration& configuration, const View& view, int threads,
                             const std::function<void(double)>& progress,
                             const OpeningListener& opening = {});

}  // namespace lanescope
