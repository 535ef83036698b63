// SPDX-License-Identifier: MIT
#include "analysis/tables/memory_places.h"

#include <algorithm>
#include <set>

#include "analysis/report/figures.h"

namespace lanescope {
namespace {

template <class Above, class Below>
std::optional<double> mean(const ReportView& view, const Series& series, int width,
                           const MemoryPlace& place, const Above& above, const Below& below) {
  return view.mean(series, width, [&](const RunRecord& run) -> std::optional<double> {
    const MemoryRecord* memory = find_memory(run, place);
    return memory ? Ratio{above(*memory), below(*memory)}.value() : std::nullopt;
  });
}

std::uint64_t issued(const MemoryRecord& memory) { return memory.issued; }
std::uint64_t active(const MemoryRecord& memory) { return memory.active; }
std::uint64_t lines(const MemoryRecord& memory) { return memory.lines; }
std::uint64_t conflicts(const MemoryRecord& memory) { return memory.conflicts; }

}  // namespace

std::vector<MemoryPlace> memory_places(const std::vector<const RunRecord*>& runs,
                                       const std::vector<std::string>& stages) {
  std::vector<MemoryPlace> places;
  for (const std::string& stage : stages) {
    std::set<std::string> mnemonics;
    for (const RunRecord* run : runs)
      if (const StageRecord* found = run->stage(stage))
        for (const MemoryRecord& memory : found->memory) mnemonics.insert(memory.mnemonic);
    for (const std::string& mnemonic : mnemonics) places.push_back({stage, mnemonic});
  }
  return places;
}

const MemoryRecord* find_memory(const RunRecord& run, const MemoryPlace& place) {
  const StageRecord* stage = run.stage(place.stage);
  if (!stage) return nullptr;
  const auto found = std::find_if(stage->memory.begin(), stage->memory.end(),
                                  [&](const auto& m) { return m.mnemonic == place.mnemonic; });
  return found == stage->memory.end() ? nullptr : &*found;
}

std::optional<double> mean_lines(const ReportView& view, const Series& series, int width,
                                 const MemoryPlace& place) {
  return mean(view, series, width, place, lines, issued);
}

std::optional<double> mean_lanes_on(const ReportView& view, const Series& series, int width,
                                    const MemoryPlace& place) {
  return mean(view, series, width, place, active, issued);
}

std::optional<double> mean_conflicts(const ReportView& view, const Series& series, int width,
                                     const MemoryPlace& place) {
  return mean(view, series, width, place, conflicts, active);
}

std::optional<double> mean_share_of_lines(const ReportView& view, const Series& series, int width,
                                          const MemoryPlace& place, std::size_t count) {
  const auto of_count = [&](const MemoryRecord& memory) {
    return count < memory.lines_histogram.size() ? memory.lines_histogram[count] : 0;
  };
  return mean(view, series, width, place, of_count, issued);
}

}  // namespace lanescope
