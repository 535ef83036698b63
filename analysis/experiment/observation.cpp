// SPDX-License-Identifier: MIT
#include "analysis/experiment/observation.h"

#include <algorithm>
#include <bit>
#include <map>
#include <tuple>

#include "simulator/memory.h"

namespace lanescope {
std::size_t MemoryAndSource::PlaceHash::operator()(const Place& place) const {
  const auto file = reinterpret_cast<std::uintptr_t>(place.file);
  const auto info = reinterpret_cast<std::uintptr_t>(place.info);
  const std::uint64_t mixed =
      (file ^ info << 7 ^ place.stage << 3 ^ place.line) * 0x9e3779b97f4a7c15u;
  return mixed >> 32;
}

MemoryAndSource::Sum& MemoryAndSource::sum_at(const Place& place) {
  Recent& recent = recent_[PlaceHash()(place) % kRecent];
  if (recent.sum == nullptr || recent.place != place) recent = {place, &sums_[place]};
  return *recent.sum;
}

void MemoryAndSource::issued(const IssueEvent& event) {
  Sum& sum = sum_at({event.at.file_name(), event.at.line(), event.stage, &event.info});
  sum.issued += 1;
  sum.active += event.charged();
  sum.overhead += event.overhead;
  if (event.info.instruction_class == InstructionClass::kMemory || !event.touches.empty())
    add_touches(sum.memory, event);
}

void MemoryAndSource::add_touches(MemoryRecord& memory, const IssueEvent& event) {
  lines_touched_.clear();
  std::size_t lines = 0;
  bool stores = false, ascend = true;
  std::int64_t latest = -1, latest_line = -1;
  for (const Touch& touch : event.touches) {
    const auto byte = static_cast<std::int64_t>(touch.byte);
    const auto line = static_cast<std::int64_t>(touch.byte / kLineBytes);
    if (line != latest_line) lines += lines_touched_.insert(touch.byte / kLineBytes);
    stores |= touch.stores();
    ascend &= byte > latest;
    latest = byte;
    latest_line = line;
  }
  memory.issued += 1;
  memory.active += static_cast<std::uint64_t>(std::popcount(event.active));
  memory.lines += lines;
  // A lane may touch several words: there can be more lines than lanes.
  const std::size_t places = std::max(static_cast<std::size_t>(event.width), lines) + 1;
  if (memory.lines_histogram.size() < places) memory.lines_histogram.resize(places);
  memory.lines_histogram[lines] += 1;
  // Where elements ascend, as they mostly do, no two are the same.
  if (stores && !ascend) memory.conflicts += count_conflicts(event.touches);
}

std::uint64_t MemoryAndSource::count_conflicts(std::span<const Touch> touches) {
  elements_stored_.clear();
  std::uint64_t lanes_in_conflict = 0;
  for (const Touch& touch : touches)
    if (touch.stores() && !elements_stored_.insert(touch.byte))
      lanes_in_conflict |= std::uint64_t{1} << touch.lane;
  return static_cast<std::uint64_t>(std::popcount(lanes_in_conflict));
}

MemoryAndSource& MemoryAndSource::operator+=(const MemoryAndSource& other) {
  for (const auto& [place, from] : other.sums_) {
    Sum& sum = sums_[place];
    sum.issued += from.issued;
    sum.active += from.active;
    sum.overhead += from.overhead;
    sum.memory += from.memory;
  }
  return *this;
}

std::vector<MemoryRecord> MemoryAndSource::memory(std::size_t stage) const {
  std::map<std::string_view, MemoryRecord> by_mnemonic;
  for (const auto& [place, sum] : sums_)
    if (place.stage == stage && sum.memory.issued > 0)
      by_mnemonic[place.info->mnemonic] += sum.memory;
  std::vector<MemoryRecord> records;
  for (auto& [mnemonic, record] : by_mnemonic) {
    record.mnemonic = mnemonic;
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<SourceLineRecord> MemoryAndSource::source_lines(
    std::span<const std::string_view> stages) const {
  // By the file's name: two translation units may have it at two addresses.
  std::map<std::tuple<std::string_view, std::uint32_t, std::size_t>, SourceLineRecord> by_line;
  for (const auto& [place, sum] : sums_) {
    SourceLineRecord& line = by_line[{place.file, place.line, place.stage}];
    line.issued += sum.issued;
    line.active += sum.active;
    line.overhead += sum.overhead;
  }
  std::vector<SourceLineRecord> records;
  for (auto& [place, line] : by_line) {
    const auto& [file, number, stage] = place;
    line.file = file;
    line.line = number;
    line.stage = stages[stage];
    records.push_back(std::move(line));
  }
  return records;
}

bool is_observed(const Work& work, int every) {
  return every != 0 && (work.segment + work.ordinal) % static_cast<std::uint64_t>(every) == 0;
}

}  // namespace lanescope
