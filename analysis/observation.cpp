// SPDX-License-Identifier: MIT
#include "analysis/observation.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include "simulator/base/random.h"
#include "simulator/memory.h"

namespace lanescope {

bool SmallSet::insert(std::uint64_t number) {
  for (std::size_t i = mix64(number) % kSlots;; i = (i + 1) % kSlots) {
    Slot& slot = slots_[i];
    if (slot.generation != generation_) {
      slot = {number, generation_};
      return true;
    }
    if (slot.number == number) return false;
  }
}

std::size_t MemoryAndSource::PlaceHash::operator()(const Place& place) const {
  return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(place.file)) ^
         (std::size_t{place.line} << 8) ^ (place.stage << 24);
}

void MemoryAndSource::issued(const IssueEvent& event) {
  Issued& line = lines_[{event.at.file_name(), event.at.line(), event.stage}];
  line.issued += 1;
  line.active += event.charged();
  line.overhead += event.overhead;
  if (!event.touches.empty()) touched(event);
}

void MemoryAndSource::touched(const IssueEvent& event) {
  MemoryRecord& record = memory_[{event.stage, event.info.mnemonic}];
  record.lines_histogram.resize(static_cast<std::size_t>(event.width) + 1);
  lines_touched_.clear();
  elements_stored_.clear();
  std::size_t lines = 0;
  std::uint64_t lanes_in_conflict = 0;
  for (const Touch& touch : event.touches) {
    lines += lines_touched_.insert(touch.byte / kLineBytes);
    if (touch.is_store && !elements_stored_.insert(touch.byte))
      lanes_in_conflict |= std::uint64_t{1} << touch.lane;
  }
  record.issued += 1;
  record.active += static_cast<std::uint64_t>(std::popcount(event.active));
  record.lines += lines;
  record.lines_histogram[lines] += 1;
  record.conflicts += static_cast<std::uint64_t>(std::popcount(lanes_in_conflict));
}

MemoryAndSource& MemoryAndSource::operator+=(const MemoryAndSource& other) {
  for (const auto& [place, counts] : other.lines_) {
    Issued& line = lines_[place];
    line.issued += counts.issued;
    line.active += counts.active;
    line.overhead += counts.overhead;
  }
  for (const auto& [key, counts] : other.memory_) {
    MemoryRecord& record = memory_[key];
    record.issued += counts.issued;
    record.active += counts.active;
    record.lines += counts.lines;
    record.conflicts += counts.conflicts;
    record.lines_histogram.resize(counts.lines_histogram.size());
    for (std::size_t k = 0; k < counts.lines_histogram.size(); ++k)
      record.lines_histogram[k] += counts.lines_histogram[k];
  }
  return *this;
}

std::vector<MemoryRecord> MemoryAndSource::memory(std::size_t stage) const {
  std::vector<MemoryRecord> records;
  for (const auto& [key, counts] : memory_) {
    if (key.first != stage) continue;
    records.push_back(counts);
    records.back().mnemonic = key.second;
  }
  return records;
}

std::vector<SourceLineRecord> MemoryAndSource::source_lines(
    std::span<const std::string_view> stages) const {
  // By name: two translation units have names of one file at two addresses.
  std::map<std::tuple<std::string, std::uint32_t, std::size_t>, Issued> by_name;
  for (const auto& [place, counts] : lines_) {
    Issued& line = by_name[{place.file, place.line, place.stage}];
    line.issued += counts.issued;
    line.active += counts.active;
    line.overhead += counts.overhead;
  }
  std::vector<SourceLineRecord> records;
  for (const auto& [place, counts] : by_name)
    records.push_back({std::get<0>(place), std::get<1>(place),
                       std::string(stages[std::get<2>(place)]), counts.issued, counts.active,
                       counts.overhead});
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
