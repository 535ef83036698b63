// SPDX-License-Identifier: MIT
#include "analysis/machines/crossover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lanescope {
namespace {

/// The crossing, or the end of the widths measured that is nearest to where it must be; both as
/// logarithms to the base of two. Requires widths.
double clamped_crossing(const Crossover& crossover) {
  if (crossover.crossing) return std::log2(*crossover.crossing);
  const bool second_wins = crossover.widths.front().ratio() < 1.0;
  return std::log2(second_wins ? crossover.widths.front().width : crossover.widths.back().width);
}

std::vector<CostRatio> ratios_of(const std::vector<SlotsAtWidth>& widths) {
  std::vector<CostRatio> ratios;
  for (const SlotsAtWidth& at : widths) ratios.push_back({at.width, at.ratio()});
  return ratios;
}

/// The instructions that runs of a pair issue.
std::set<std::string> mnemonics_of(const Report& report, const KernelPair& pair) {
  std::set<std::string> mnemonics;
  for (const RunRecord& run : report.runs) {
    const std::string& kernel = run.configuration.kernel;
    if (kernel != pair.first.kernel && kernel != pair.second.kernel) continue;
    for (const StageRecord& stage : run.stages)
      for (const InstructionRecord& counts : stage.instructions) mnemonics.insert(counts.mnemonic);
  }
  return mnemonics;
}

}  // namespace

std::vector<std::string> vector_kernels(const Report& report) {
  std::vector<std::string> kernels;
  for (const RunRecord& run : report.runs)
    if (!run.stages.empty() &&
        std::find(kernels.begin(), kernels.end(), run.configuration.kernel) == kernels.end())
      kernels.push_back(run.configuration.kernel);
  return kernels;
}

std::vector<KernelPair> pairs_of(const ReportView& view, const std::string& first,
                                 const std::string& second) {
  const std::vector<Series> all = series_of(view.report());
  std::vector<KernelPair> pairs;
  for (const Series& series : all) {
    const Series other{second, series.facet};
    if (series.kernel == first && std::find(all.begin(), all.end(), other) != all.end())
      pairs.push_back({series, other});
  }
  return pairs;
}

std::string Crossover::words() const {
  if (widths.empty()) return "unknown";
  const bool wins_at_first = widths.front().ratio() < 1.0;
  if (crossing) return fmt::format("{}{:.1f}", wins_at_first ? "falls behind at " : "", *crossing);
  return wins_at_first ? fmt::format("below {}", widths.front().width)
                       : fmt::format("above {}", widths.back().width);
}

Crossover crossover(const ReportView& view, const KernelPair& pair, const ReportCosts& costs) {
  const auto slots = [&](const Series& series, int width) {
    return view.mean(series, width,
                     [&](const RunRecord& run) { return costs.slots_per_element(run); });
  };
  Crossover result;
  for (const int width : view.widths(pair.first)) {
    const auto first = slots(pair.first, width);
    const auto second = slots(pair.second, width);
    if (first && second && *first > 0.0) result.widths.push_back({width, *first, *second});
  }
  result.crossing = crossing_point(ratios_of(result.widths));
  return result;
}

double Sensitivity::moved() const {
  if (halved.widths.empty() || doubled.widths.empty()) return 0.0;
  return std::abs(clamped_crossing(doubled) - clamped_crossing(halved));
}

double Sensitivity::changed() const {
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(halved.widths.size(), doubled.widths.size()); ++i)
    most =
        std::max(most, std::abs(std::log2(doubled.widths[i].ratio() / halved.widths[i].ratio())));
  return most;
}

std::optional<double> Sensitivity::break_even() const {
  if (halved.widths.empty() || doubled.widths.empty()) return std::nullopt;
  const auto lead = [](const Crossover& with) {
    return with.widths.back().second - with.widths.back().first;
  };
  // Linear in the factor.
  const double slope = (lead(doubled) - lead(halved)) / (2.0 - 0.5);
  if (slope == 0.0) return std::nullopt;
  const double factor = 0.5 - lead(halved) / slope;
  return factor < 0.0 ? std::nullopt : std::optional(factor);
}

std::vector<std::vector<Sensitivity>> sensitivities(const ReportView& view,
                                                    const std::vector<KernelPair>& pairs,
                                                    const MachineDescription& machine,
                                                    SequenceTrials& trials) {
  std::vector<std::vector<Sensitivity>> all(pairs.size());
  if (pairs.empty()) return all;
  // Prices are for all pairs alike.
  for (const std::string& mnemonic : mnemonics_of(view.report(), pairs.front())) {
    const ReportCosts halved(view.report(), machine, trials, {{mnemonic, 0.5}});
    const ReportCosts doubled(view.report(), machine, trials, {{mnemonic, 2.0}});
    for (std::size_t i = 0; i < pairs.size(); ++i)
      all[i].push_back(
          {mnemonic, crossover(view, pairs[i], halved), crossover(view, pairs[i], doubled)});
  }
  for (std::vector<Sensitivity>& each : all)
    std::stable_sort(each.begin(), each.end(), [](const Sensitivity& a, const Sensitivity& b) {
      return std::pair(a.moved(), a.changed()) > std::pair(b.moved(), b.changed());
    });
  return all;
}

}  // namespace lanescope
