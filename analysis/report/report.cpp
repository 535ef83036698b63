// SPDX-License-Identifier: MIT
#include "analysis/report/report.h"

#include <algorithm>

namespace lanescope {

InstructionRecord StageRecord::total() const {
  InstructionRecord sum;
  for (const InstructionRecord& counts : instructions) {
    sum.issued += counts.issued;
    sum.active += counts.active;
    sum.overhead_issued += counts.overhead_issued;
    sum.overhead_active += counts.overhead_active;
  }
  return sum;
}

const StageRecord* RunRecord::stage(std::string_view name) const {
  const auto found =
      std::find_if(stages.begin(), stages.end(), [&](const auto& s) { return s.name == name; });
  return found == stages.end() ? nullptr : &*found;
}

std::optional<std::uint64_t> RunRecord::counter(std::string_view name) const {
  const auto found =
      std::find_if(counters.begin(), counters.end(), [&](const auto& c) { return c.name == name; });
  if (found == counters.end()) return std::nullopt;
  return found->value;
}

const SeriesRecord* RunRecord::find_series(std::string_view name) const {
  const auto found =
      std::find_if(series.begin(), series.end(), [&](const auto& s) { return s.name == name; });
  return found == series.end() ? nullptr : &*found;
}

}  // namespace lanescope
