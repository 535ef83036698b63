// SPDX-License-Identifier: MIT
#include "analysis/experiment/observation.h"

#include <algorithm>
#include <bit>
#include <map>
#include <tuple>

#include "simulator/memory.h"

namespace lanescope {
namespace {

void add(MemoryRecord& to, const MemoryRecord& from) {
  to.issued += from.issued;
  to.active += from.active;
  to.lines += from.lines;
  to.conflicts += from.conflicts;
  if (to.lines_histogram.size() < from.lines_histogram.size())
    to.lines_histogram.resize(from.lines_histogram.size());
  for (std::size_t k = 0; k < from.lines_histogram.size(); ++k)
    to.lines_histogram[k] += from.lines_histogram[k];
}

}  // namespace

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
  elements_stored_.clear();
  std::size_t lines = 0;
  std::uint64_t lanes_in_conflict = 0;
  for (const Touch& touch : event.touches) {
    lines += lines_touched_.insert(touch.byte / kLineBytes);
    if (touch.stores() && !elements_stored_.insert(touch.byte))
      lanes_in_conflict |= std::uint64_t{1} << touch.lane;
  }
  memory.issued += 1;
  memory.active += static_cast<std::uint64_t>(std::popcount(event.active));
  memory.lines += lines;
  // Records of several words can touch more lines than there are lanes.
  memory.lines_histogram.resize(std::max(
      {memory.lines_histogram.size(), static_cast<std::size_t>(event.width) + 1, lines + 1}));
  memory.lines_histogram[lines] += 1;
  memory.conflicts += static_cast<std::uint64_t>(std::popcount(lanes_in_conflict));
}

MemoryAndSource& MemoryAndSource::operator+=(const MemoryAndSource& other) {
  for (const auto& [place, from] : other.sums_) {
    Sum& sum = sums_[place];
    sum.issued += from.issued;
    sum.active += from.active;
    sum.overhead += from.overhead;
    add(sum.memory, from.memory);
  }
  return *this;
}

std::vector<MemoryRecord> MemoryAndSource::memory(std::size_t stage) const {
  std::map<std::string_view, MemoryRecord> by_mnemonic;
  for (const auto& [place, sum] : sums_)
    if (place.stage == stage && sum.memory.issued > 0)
      add(by_mnemonic[place.info->mnemonic], sum.memory);
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

bool is_observed(const Packet& packet, int every, int packet_capacity) {
  if (every == 0) return false;
  const std::uint64_t segment = packet.first_id >> 32;
  const std::uint64_t ordinal =
      (packet.first_id & 0xffffffffu) / static_cast<std::uint64_t>(packet_capacity);
  return (segment + ordinal) % static_cast<std::uint64_t>(every) == 0;
}

}  // namespace lanescope
