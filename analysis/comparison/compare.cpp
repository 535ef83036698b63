// SPDX-License-Identifier: MIT
#include "analysis/comparison/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/base/json_text.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/figures.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;
using Counts = std::vector<std::uint64_t>;

/// One figure of a run. A list stands for itself beside its sum.
struct RunValue {
  std::string stage;
  std::string figure;
  const Unit* unit;
  bool is_detail;
  Json value;
  Counts list;
};

/// Collects the figures of a run.
class RunValues {
 public:
  /// `with_observed`: also what depends on which pieces of work were observed; `with_groups`: also
  /// the groups of lanes among that.
  RunValues(const RunRecord& run, bool with_observed, bool with_groups)
      : run_(run), with_observed_(with_observed), with_groups_(with_groups) {
    add_run();
    for (const StageRecord& stage : run.stages) add_stage(stage);
    for (const SeriesRecord& series : run.series) add_list("", series.name, series.values);
  }

  const std::vector<RunValue>& all() const { return values_; }

 private:
  void add(const std::string& stage, const std::string& figure, Json value,
           const Unit& unit = kCount) {
    values_.push_back({stage, figure, &unit, false, std::move(value), {}});
  }
  void add_detail(const std::string& stage, const std::string& figure, std::uint64_t value) {
    values_.push_back({stage, figure, &kCount, true, value, {}});
  }
  void add_list(const std::string& stage, const std::string& figure, const Counts& list) {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : list) sum += count;
    values_.push_back({stage, figure, &kCount, true, sum, list});
  }
  void add_ratio(const std::string& stage, const std::string& figure, std::optional<double> value,
                 const Unit& unit) {
    add(stage, figure, number_or_null(value), unit);
  }

  void add_counters(const std::string& stage, const std::vector<CounterRecord>& counters) {
    for (const CounterRecord& counter : counters) add(stage, counter.name, counter.value);
  }

  void add_run() {
    add("", "source_hash", hash_text(run_.source.hash));
    add("", "results_hash", hash_text(run_.results_hash));
    add("", "output_hash", hash_text(run_.output.hash));
    add_counters(kOutput, run_.output.counters);
    add(kSource, "pieces", run_.source.pieces);
    if (with_observed_) add(kSource, "pieces_observed", run_.source.pieces_observed);
    add_counters(kSource, run_.source.counters);
    add_counters("", run_.counters);
    for (const MetricRecord& metric : run_.metrics)
      add_ratio("", metric.name, counter_ratio(run_, metric.numerator, metric.denominator),
                kMeasure);
    if (run_.stages.empty()) return;
    add_total(kAllStages, total(run_), utilization(run_), instructions_per_element(run_));
  }

  void add_total(const std::string& stage, const InstructionRecord& sum, const Ratio& utilization,
                 std::optional<double> per_element) {
    add(stage, "issued", sum.issued);
    add(stage, "active", sum.active);
    add(stage, "overhead_issued", sum.overhead_issued);
    add(stage, "overhead_active", sum.overhead_active);
    add_ratio(stage, "utilization", utilization.value(), kPercent);
    add_ratio(stage, "issued_per_element", per_element, kInstructions);
  }

  void add_stage(const StageRecord& stage) {
    add_total(stage.name, stage.total(), utilization(stage, run_.configuration.width),
              instructions_per_element(run_, stage.name));
    for (const InstructionRecord& counts : stage.instructions) {
      add_detail(stage.name, counts.mnemonic + " issued", counts.issued);
      add_detail(stage.name, counts.mnemonic + " active", counts.active);
      add_detail(stage.name, counts.mnemonic + " overhead_issued", counts.overhead_issued);
      add_detail(stage.name, counts.mnemonic + " overhead_active", counts.overhead_active);
    }
    add_list(stage.name, "lane_active", stage.lane_active);
    add_list(stage.name, "histogram", stage.histogram);
    if (!with_observed_) return;
    for (const MemoryRecord& memory : stage.memory) {
      add_detail(stage.name, memory.mnemonic + " observed", memory.issued);
      add_detail(stage.name, memory.mnemonic + " observed active", memory.active);
      add_detail(stage.name, memory.mnemonic + " lines", memory.lines);
      add_detail(stage.name, memory.mnemonic + " conflicts", memory.conflicts);
      add_list(stage.name, memory.mnemonic + " lines_histogram", memory.lines_histogram);
    }
    if (!with_groups_) return;
    for (const LaneGroupRecord& record : stage.lane_groups) {
      add_list(stage.name, record.mnemonic + " active_groups", counts_of(record.groups.active));
      add_list(stage.name, record.mnemonic + " dense_groups", counts_of(record.groups.dense));
    }
  }

  static Counts counts_of(const GroupCounts& groups) { return {groups.begin(), groups.end()}; }

  static constexpr const char* kAllStages = "All stages";
  static constexpr const char* kSource = "Source";
  static constexpr const char* kOutput = "Output";

  const RunRecord& run_;
  bool with_observed_;
  bool with_groups_;
  std::vector<RunValue> values_;
};

/// Sum of the differences of two lists, place by place.
double distance(const Counts& a, const Counts& b) {
  const auto at = [](const Counts& list, std::size_t i) {
    return i < list.size() ? static_cast<double>(list[i]) : 0.0;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    sum += std::abs(at(b, i) - at(a, i));
  return sum;
}

/// A figure that is not the same, or is there only once: the other is then null.
Change change_of(const RunValue* before, const RunValue* after, double tolerance) {
  const RunValue& known = before ? *before : *after;
  Change change{known.stage, known.figure, known.unit, known.is_detail, {}, {}, {}, {}, false};
  if (before) change.before = before->value;
  if (after) change.after = after->value;
  if (change.before.is_string() && change.after.is_string())
    change.within_tolerance = tolerance > 0.0;
  if (!change.before.is_number() || !change.after.is_number()) return change;
  const double old = change.before.get<double>();
  change.difference =
      known.list.empty() ? change.after.get<double>() - old : distance(before->list, after->list);
  if (old == 0.0) return change;
  change.relative = *change.difference / std::abs(old);
  // Ratios carry rounding errors, which must not push one over a tolerance that its counts meet.
  change.within_tolerance = std::abs(*change.relative) <= tolerance * (1.0 + 1e-9);
  return change;
}

double size_of(const Change& change) {
  return change.relative ? std::abs(*change.relative) : std::numeric_limits<double>::infinity();
}

/// Reports of earlier programs do not have the groups of lanes.
bool has_groups(const RunRecord& run) {
  return std::any_of(run.stages.begin(), run.stages.end(),
                     [](const StageRecord& stage) { return !stage.lane_groups.empty(); });
}

std::vector<Change> changes_between(const RunRecord& before, const RunRecord& after,
                                    double tolerance) {
  const bool with_observed =
      before.configuration.observe_every == after.configuration.observe_every;
  const bool with_groups = has_groups(before) && has_groups(after);
  const RunValues old(before, with_observed, with_groups);
  const RunValues now(after, with_observed, with_groups);
  // A name may be that of several figures, say of a counter and a series: those are in one order.
  std::multimap<std::pair<std::string, std::string>, const RunValue*> unseen;
  for (const RunValue& value : now.all())
    unseen.emplace(std::pair(value.stage, value.figure), &value);
  std::vector<Change> changes;
  for (const RunValue& value : old.all()) {
    const auto [first, last] = unseen.equal_range({value.stage, value.figure});
    const RunValue* other = first == last ? nullptr : first->second;
    if (other) unseen.erase(first);
    if (!other || other->value != value.value || other->list != value.list)
      changes.push_back(change_of(&value, other, tolerance));
  }
  for (const auto& [key, value] : unseen) changes.push_back(change_of(nullptr, value, tolerance));
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return a.is_detail != b.is_detail ? b.is_detail : size_of(a) > size_of(b);
  });
  return changes;
}

/// Parameters as words: those of the names given.
std::string run_title(const Json& parameters, const std::set<std::string>& names) {
  std::string text;
  for (const auto& [name, value] : parameters.items()) {
    if (!names.contains(name)) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name,
                        value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

/// The parameters that a run of any kernel goes by.
std::set<std::string> always_named() {
  std::set<std::string> names{"kernel", "width_lanes", "scene"};
  for (const Workload* workload : workloads()) names.emplace(workload->facet);
  return names;
}

/// The runs of a report by those of their parameters that are not ignored.
class RunIndex {
 public:
  RunIndex(const NamedReport& source, const std::set<std::string>& ignored) {
    for (const RunRecord& run : source.report.runs) {
      Json parameters = configuration_json(run.configuration);
      for (const std::string& name : ignored) parameters.erase(name);
      if (!by_key_.emplace(key_of(parameters), parameters_.size()).second)
        throw InputError(source.name, "two runs have the same parameters but for those ignored: {}",
                         run_title(parameters, always_named()));
      parameters_.push_back(parameters);
    }
  }

  const Json& parameters(std::size_t run) const { return parameters_[run]; }
  std::optional<std::size_t> find(const Json& parameters) const {
    const auto found = by_key_.find(key_of(parameters));
    return found == by_key_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::vector<Json>& all() const { return parameters_; }

 private:
  /// The same for any order of the parameters.
  static std::string key_of(const Json& parameters) { return nlohmann::json(parameters).dump(); }

  std::vector<Json> parameters_;
  std::map<std::string, std::size_t> by_key_;
};

/// Names of parameters that not all runs have the same of, and of those that a run always goes by.
std::set<std::string> names_in_titles(const RunIndex& before, const RunIndex& after) {
  std::map<std::string, std::set<std::string>> values;
  for (const RunIndex* index : {&before, &after})
    for (const Json& parameters : index->all())
      for (const auto& [name, value] : parameters.items()) values[name].insert(value.dump());
  std::set<std::string> names = always_named();
  for (const auto& [name, different] : values)
    if (different.size() > 1) names.insert(name);
  return names;
}

bool is_of_all_runs(const Report& report, const std::string& parameter) {
  return std::all_of(report.runs.begin(), report.runs.end(), [&](const RunRecord& run) {
    return all_values(run.configuration).contains(parameter);
  });
}

/// The parameters by which runs are not told apart: those that `asked` names, and with the kernel
/// also those that only some kernels take.
std::set<std::string> ignored_in(const NamedReport& before, const NamedReport& after,
                                 const std::set<std::string>& asked) {
  std::vector<std::string> names;
  for (const NamedReport* source : {&before, &after}) add_parameter_names(source->report, names);
  for (const std::string& name : asked)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError("--ignore", "'{}' is not a parameter of a run in {} or {}; use {}{}", name,
                       before.name, after.name, list_or(names), did_you_mean(name, names));
  std::set<std::string> ignored = asked;
  if (asked.contains("kernel"))
    for (const std::string& name : names)
      if (!is_of_all_runs(before.report, name) || !is_of_all_runs(after.report, name))
        ignored.insert(name);
  return ignored;
}

}  // namespace

bool Comparison::same() const {
  const auto within = [](const RunChanges& run) {
    return std::all_of(run.changes.begin(), run.changes.end(),
                       [](const Change& change) { return change.within_tolerance; });
  };
  return only_before.empty() && only_after.empty() && std::all_of(runs.begin(), runs.end(), within);
}

Comparison compare(const NamedReport& before, const NamedReport& after,
                   const CompareOptions& options) {
  const std::set<std::string> ignored = ignored_in(before, after, options.ignored);
  const RunIndex old(before, ignored);
  const RunIndex now(after, ignored);
  const std::set<std::string> titled = names_in_titles(old, now);
  Comparison result;
  for (std::size_t i = 0; i < old.all().size(); ++i) {
    const Json& parameters = old.parameters(i);
    const auto other = now.find(parameters);
    if (!other) {
      result.only_before.push_back({run_title(parameters, titled), parameters});
      continue;
    }
    ++result.compared;
    auto changes =
        changes_between(before.report.runs[i], after.report.runs[*other], options.tolerance);
    if (!changes.empty())
      result.runs.push_back({run_title(parameters, titled), parameters, std::move(changes)});
  }
  for (const Json& parameters : now.all())
    if (!old.find(parameters))
      result.only_after.push_back({run_title(parameters, titled), parameters});
  return result;
}

}  // namespace lanescope
