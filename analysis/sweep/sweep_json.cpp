// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep_json.h"

#include "analysis/base/json_text.h"

namespace lanescope {
namespace {

constexpr int kSummaryVersion = 3;
constexpr std::string_view kSummarySchema = "lanescope-sweep-summary";

}  // namespace

std::string summary_text(const SweepSummary& s) {
  return json_text({{"schema", {{"name", kSummarySchema}, {"version", kSummaryVersion}}},
                    {"cells", s.cells},
                    {"skipped", s.skipped},
                    {"done", s.done},
                    {"failed", s.failed},
                    {"elsewhere", s.elsewhere},
                    {"groups", s.groups},
                    {"wall_ms", json_ms(s.wall_ms)},
                    {"threads", s.threads},
                    {"kernel_ms", json_ms(s.kernel_ms)},
                    {"observation_ms", json_ms(s.observation_ms)},
                    {"source_ms", json_ms(s.source_ms)},
                    {"source_unshared_ms", json_ms(s.source_unshared_ms)},
                    {"work_ms", json_ms(s.work_ms())},
                    {"work_unshared_ms", json_ms(s.work_unshared_ms())},
                    {"peak_memory_bytes", s.peak_memory_bytes}});
}

}  // namespace lanescope
