// SPDX-License-Identifier: MIT
#include "analysis/report/report.h"

#include <algorithm>

namespace lanescope {
namespace {

std::optional<std::uint64_t> value_of(const std::vector<CounterRecord>& counters,
                                      std::string_view name) {
  const auto found =
      std::find_if(counters.begin(), counters.end(), [&](const auto& c) { return c.name == name; });
  if (found == counters.end()) return std::nullopt;
  return found->value;
}

}  // namespace

InstructionRecord& InstructionRecord::operator+=(const InstructionRecord& other) {
  issued += other.issued;
  active += other.active;
  overhead_issued += other.overhead_issued;
  overhead_active += other.overhead_active;
  return *this;
}

MemoryRecord& MemoryRecord::operator+=(const MemoryRecord& other) {
  issued += other.issued;
  active += other.active;
  lines += other.lines;
  if (lines_histogram.size() < other.lines_histogram.size())
    lines_histogram.resize(other.lines_histogram.size());
  for (std::size_t k = 0; k < other.lines_histogram.size(); ++k)
    lines_histogram[k] += other.lines_histogram[k];
  conflicts += other.conflicts;
  return *this;
}

LaneGroupRecord& LaneGroupRecord::operator+=(const LaneGroupRecord& other) {
  issued += other.issued;
  groups += other.groups;
  return *this;
}

InstructionRecord StageRecord::total() const {
  InstructionRecord sum;
  for (const InstructionRecord& counts : instructions) sum += counts;
  return sum;
}

MemoryRecord StageRecord::memory_total() const {
  MemoryRecord sum;
  for (const MemoryRecord& counts : memory) sum += counts;
  return sum;
}

const StageRecord* RunRecord::stage(std::string_view name) const {
  const auto found =
      std::find_if(stages.begin(), stages.end(), [&](const auto& s) { return s.name == name; });
  return found == stages.end() ? nullptr : &*found;
}

std::optional<std::uint64_t> RunRecord::counter(std::string_view name) const {
  return value_of(counters, name);
}

std::optional<std::uint64_t> OutputRecord::counter(std::string_view name) const {
  return value_of(counters, name);
}

std::optional<double> Report::kernel_ms(std::size_t run) const {
  if (run >= timing.kernel_ms.size()) return std::nullopt;
  return timing.kernel_ms[run];
}

const SeriesRecord* RunRecord::find_series(std::string_view name) const {
  const auto found =
      std::find_if(series.begin(), series.end(), [&](const auto& s) { return s.name == name; });
  return found == series.end() ? nullptr : &*found;
}

void add_parameter_names(const Report& report, std::vector<std::string>& names) {
  for (const RunRecord& run : report.runs)
    for (const auto& [name, value] : all_values(run.configuration).all())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace lanescope
