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
  tell_memory(output_bytes(configurations, limits));
}

void tell_memory(std::uint64_t output_bytes) {
  if (output_bytes >= kMuch)
    tell(fmt::format("outputs (frames) take {} of memory", memory_text(output_bytes)));
}

}  // namespace lanescope
