// SPDX-License-Identifier: MIT
#include "analysis/cli/memory_notice.h"

#include <fmt/format.h>

#include "analysis/base/memory.h"
#include "analysis/cli/output.h"

namespace lanescope {
namespace {

/// More than the groups of an experiment usually take.
constexpr std::uint64_t kMuch = 1'000'000'000;

}  // namespace

void tell_memory(const std::vector<Configuration>& configurations, const GroupLimits& limits) {
  const std::uint64_t bytes = output_bytes(configurations, limits);
  if (bytes >= kMuch) tell(fmt::format("outputs (frames) take {} of memory", memory_text(bytes)));
}

}  // namespace lanescope
