// SPDX-License-Identifier: MIT
#include "analysis/report/merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/configuration/configuration_json.h"
#include "analysis/report/report_json.h"
#include "analysis/report/run_order.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// Something of one of the reports, and the report's name.
template <class Value>
struct Named {
  Value value;
  std::string name;
};

void require_same_program(const NamedReport& first, const NamedReport& other) {
  const auto program = [](const Report& report) {
    return report.commit.empty()
               ? report.program_version
               : fmt::format("{} (commit {})", report.program_version, report.commit);
  };
  if (program(first.report) != program(other.report))
    throw InputError(other.name,
                     "was made by lanescope {}, and {} by {}; merge reports of one version",
                     program(other.report), first.name, program(first.report));
}

auto explanation(const InstructionEntry& entry) {
  return std::tie(entry.meaning, entry.instruction_class, entry.charge);
}

/// The explanations of all instructions, by mnemonic.
class Dictionary {
 public:
  void add(const NamedReport& from) {
    for (const InstructionEntry& entry : from.report.instructions) {
      const auto [place, is_new] = entries_.try_emplace(entry.mnemonic, entry, from.name);
      const auto& [known, name] = place->second;
      if (!is_new && explanation(known) != explanation(entry))
        throw InputError(from.name, "explains the instruction '{}' differently from {}",
                         entry.mnemonic, name);
    }
  }
  std::vector<InstructionEntry> entries() const {
    std::vector<InstructionEntry> entries;
    for (const auto& [mnemonic, entry] : entries_) entries.push_back(entry.value);
    return entries;
  }

 private:
  std::map<std::string, Named<InstructionEntry>> entries_;
};

/// The runs of all reports with their times, each once.
class Runs {
 public:
  void add(const NamedReport& from) {
    for (std::size_t i = 0; i < from.report.runs.size(); ++i) {
      const RunRecord& run = from.report.runs[i];
      const auto [place, is_new] =
          runs_.try_emplace(configuration_json(run.configuration).dump(),
                            Named<Timed>{{&run, from.report.timing.kernel_ms[i]}, from.name});
      if (is_new) continue;
      const auto& [known, name] = place->second;
      if (to_json(*known.run) != to_json(run))
        throw InputError(from.name, "has other counts than {} for the same parameters: {}", name,
                         place->first);
    }
  }
  void write(Report& report) const {
    std::vector<std::pair<std::vector<Rank>, Timed>> placed;
    for (const auto& [parameters, run] : runs_)
      placed.emplace_back(place_of(*run.value.run), run.value);
    std::stable_sort(placed.begin(), placed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [place, timed] : placed) {
      report.runs.push_back(*timed.run);
      report.timing.kernel_ms.push_back(timed.kernel_ms);
    }
  }

 private:
  struct Timed {
    const RunRecord* run;
    double kernel_ms;
  };
  std::map<std::string, Named<Timed>> runs_;  ///< By their parameters.
};

/// The different texts, in the order of their first appearance.
std::string distinct(const std::vector<NamedReport>& reports, std::string Timing::*text) {
  std::vector<std::string> texts;
  for (const NamedReport& r : reports)
    if (std::find(texts.begin(), texts.end(), r.report.timing.*text) == texts.end())
      texts.push_back(r.report.timing.*text);
  return fmt::format("{}", fmt::join(texts, "; "));
}

void add_times(Timing& sum, const Timing& timing) {
  sum.wall_ms += timing.wall_ms;
  sum.source_ms += timing.source_ms;
  sum.observation_ms += timing.observation_ms;
  sum.threads = std::max(sum.threads, timing.threads);
  sum.peak_memory_bytes = std::max(sum.peak_memory_bytes, timing.peak_memory_bytes);
}

}  // namespace

Report single_run(const Report& report, std::size_t run) {
  Report single = report;
  single.runs = {report.runs[run]};
  std::set<std::string> issued;
  for (const StageRecord& stage : single.runs.front().stages)
    for (const InstructionRecord& counts : stage.instructions) issued.insert(counts.mnemonic);
  std::erase_if(single.instructions,
                [&](const InstructionEntry& entry) { return !issued.contains(entry.mnemonic); });
  const auto share = static_cast<double>(report.runs.size());
  single.timing.kernel_ms = {report.timing.kernel_ms[run]};
  single.timing.wall_ms /= share;
  single.timing.source_ms /= share;
  single.timing.observation_ms /= share;
  return single;
}

Report merge_reports(const std::vector<NamedReport>& reports) {
  LANESCOPE_CHECK(!reports.empty(), "no reports to merge");
  Report merged;
  merged.program_version = reports.front().report.program_version;
  merged.commit = reports.front().report.commit;
  Dictionary dictionary;
  Runs runs;
  for (const NamedReport& from : reports) {
    require_same_program(reports.front(), from);
    dictionary.add(from);
    runs.add(from);
    add_times(merged.timing, from.report.timing);
  }
  merged.instructions = dictionary.entries();
  runs.write(merged);
  merged.timing.host = distinct(reports, &Timing::host);
  merged.timing.compiler = distinct(reports, &Timing::compiler);
  return merged;
}

}  // namespace lanescope
