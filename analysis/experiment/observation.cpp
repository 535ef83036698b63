// SPDX-License-Identifier: MIT
#include "analysis/experiment/observation.h"

#include <algorithm>
#include <bit>
#include <map>
#include <tuple>
#include <utility>

#include "simulator/memory.h"

namespace lanescope {

inline MemoryAndSource::Sum& MemoryAndSource::slot_of(const Place& place) {
  const std::uint64_t mixed = (reinterpret_cast<std::uintptr_t>(place.file) ^
                               reinterpret_cast<std::uintptr_t>(place.info) << 7 ^
                               place.stage << 3 ^ place.line ^ place.block.line() << 12) *
                              0x9e3779b97f4a7c15u;
  for (std::size_t i = mixed >> 32;; ++i) {
    Sum& sum = slots_[i & (slots_.size() - 1)];
    if (sum.place == place || sum.place.info == nullptr) return sum;
  }
}

inline MemoryAndSource::Sum& MemoryAndSource::sum_at(const Place& place) {
  Sum& sum = slot_of(place);
  return sum.place.info != nullptr ? sum : new_sum(place);
}

MemoryAndSource::Sum& MemoryAndSource::new_sum(const Place& place) {
  if (2 * ++places_ > slots_.size()) {
    const auto sums = std::exchange(slots_, std::vector<Sum>(2 * slots_.size()));
    for (const Sum& sum : sums)
      if (sum.place.info != nullptr) slot_of(sum.place) = sum;
  }
  Sum& sum = slot_of(place);
  sum.place = place;
  return sum;
}

MemoryRecord& MemoryAndSource::memory_of(Sum& sum) {
  if (sum.memory == kNone) {
    sum.memory = memory_.size();
    memory_.emplace_back();
  }
  return memory_[sum.memory];
}

void MemoryAndSource::issued(const IssueEvent& event) {
  Sum& sum = sum_at({&event.info, event.at.file_name(), event.at.line(),
                     static_cast<std::uint32_t>(event.stage), event.block});
  sum.issued += 1;
  sum.active += event.charged();
  sum.overhead += event.overhead;
  if (event.active != latest_mask_) {
    latest_mask_ = event.active;
    latest_groups_ = lane_groups_of(event.active);
  }
  sum.groups += latest_groups_;
  if (event.info.instruction_class == InstructionClass::kMemory || !event.touches.empty())
    add_touches(memory_of(sum), event);
}

void MemoryAndSource::add_touches(MemoryRecord& memory, const IssueEvent& event) {
  lines_touched_.clear();
  bool stores = false, ascend = true;
  std::int64_t latest = -1, latest_line = -1;
  for (const Touch& touch : event.touches) {
    const auto byte = static_cast<std::int64_t>(touch.byte);
    const auto line = static_cast<std::int64_t>(touch.byte / kLineBytes);
    if (line != latest_line) lines_touched_.insert(touch.byte / kLineBytes);
    stores |= touch.stores();
    ascend &= byte > latest;
    latest = byte;
    latest_line = line;
  }
  const std::size_t lines = lines_touched_.size();
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
  other.for_each_sum([&](const Sum& from) {
    Sum& sum = sum_at(from.place);
    sum.issued += from.issued;
    sum.active += from.active;
    sum.overhead += from.overhead;
    sum.groups += from.groups;
    if (from.memory != kNone) memory_of(sum) += other.memory_[from.memory];
  });
  return *this;
}

namespace {

/// The records of a map by mnemonic, with it.
template <class Record>
std::vector<Record> with_mnemonics(std::map<std::string_view, Record> by_mnemonic) {
  std::vector<Record> records;
  for (auto& [mnemonic, record] : by_mnemonic) {
    record.mnemonic = mnemonic;
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace

std::vector<MemoryRecord> MemoryAndSource::memory(std::size_t stage) const {
  std::map<std::string_view, MemoryRecord> by_mnemonic;
  for_each_sum([&](const Sum& sum) {
    if (sum.place.stage == stage && sum.memory != kNone)
      by_mnemonic[sum.place.info->mnemonic] += memory_[sum.memory];
  });
  return with_mnemonics(std::move(by_mnemonic));
}

std::vector<LaneGroupRecord> MemoryAndSource::lane_groups(std::size_t stage) const {
  std::map<std::string_view, LaneGroupRecord> by_mnemonic;
  for_each_sum([&](const Sum& sum) {
    if (sum.place.stage == stage)
      by_mnemonic[sum.place.info->mnemonic] += LaneGroupRecord{{}, sum.issued, sum.groups};
  });
  return with_mnemonics(std::move(by_mnemonic));
}

std::vector<SourceLineRecord> MemoryAndSource::source_lines(
    std::span<const std::string_view> stages) const {
  // By the files' names: two translation units may have them at two addresses.
  using Key = std::tuple<std::string_view, std::uint32_t, std::size_t, std::string_view,
                         std::uint_least32_t>;
  std::map<Key, SourceLineRecord> by_line;
  for_each_sum([&](const Sum& sum) {
    const Place& place = sum.place;
    SourceLineRecord& line =
        by_line[{place.file, place.line, place.stage, place.block.file_name(), place.block.line()}];
    line.issued += sum.issued;
    line.active += sum.active;
    line.overhead += sum.overhead;
  });
  std::vector<SourceLineRecord> records;
  for (auto& [place, line] : by_line) {
    const auto& [file, number, stage, block_file, block_line] = place;
    line.place = {std::string(file), number};
    line.stage = stages[stage];
    if (block_line != 0) line.block = SourcePlace{std::string(block_file), block_line};
    records.push_back(std::move(line));
  }
  return records;
}

bool is_observed(const Work& work, int every) {
  return every != 0 && (work.segment + work.ordinal) % static_cast<std::uint64_t>(every) == 0;
}

}  // namespace lanescope
