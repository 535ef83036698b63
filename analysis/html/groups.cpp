// SPDX-License-Identifier: MIT
#include "analysis/html/groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/configuration/configuration.h"
#include "analysis/tables/report_view.h"
#include "analysis/tables/series_rows.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr std::string_view kWorkload = "workload";

struct PlacedRun {
  const NamedReport* source;
  const RunRecord* run;
  /// The kind of work, then the parameters in their order.
  Arguments values;
};

std::vector<PlacedRun> runs_of(const std::vector<NamedReport>& sources) {
  std::vector<PlacedRun> runs;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs) {
      PlacedRun placed{&source, &run, {}};
      placed.values.set(kWorkload, run.workload);
      for (const auto& [name, value] : all_values(run.configuration).all())
        placed.values.set(name, value);
      runs.push_back(std::move(placed));
    }
  return runs;
}

/// Values of arguments as a text: `edges = inline, seed = 1`.
std::string text_of(const Arguments& arguments) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : arguments.all())
    texts.push_back(fmt::format("{} = {}", name, value_text(value)));
  return fmt::format("{}", fmt::join(texts, ", "));
}

void check_no_run_twice(const std::vector<PlacedRun>& runs) {
  std::map<std::string, const PlacedRun*> seen;
  for (const PlacedRun& run : runs) {
    const auto [first, is_new] = seen.emplace(text_of(run.values), &run);
    if (is_new) continue;
    const Configuration& c = run.run->configuration;
    const std::string facet = shown_facet({c.kernel, facet_of(c)});
    throw InputError(run.source->name,
                     "has a run that {} has, too: {} on {}, W = {}{}{}; leave out one of the files",
                     first->second->source->name, c.kernel, c.scene, c.width,
                     facet.empty() ? "" : ", ", facet);
  }
}

/// Where a run stands in tables and charts.
bool is_of_place(const PlacedRun& run, std::string_view name) {
  return name == "kernel" || name == "width_lanes" || name == "scene" ||
         name == facet_name(run.run->configuration.kernel);
}

std::string place_of(const PlacedRun& run) {
  const Configuration& c = run.run->configuration;
  return fmt::format("{}\n{}\n{}\n{}", c.kernel, c.width, c.scene, facet_of(c));
}

/// The parameters whose values are not the same in all of the runs that have them.
std::set<std::string> varying(const std::vector<const PlacedRun*>& runs) {
  std::map<std::string, const Value*> first;
  std::set<std::string> names;
  for (const PlacedRun* run : runs)
    for (const auto& [name, value] : run->values.all())
      if (*first.emplace(name, &value).first->second != value) names.insert(name);
  return names;
}

bool is_decided_by_scene(const std::string& name) {
  const Parameter* const parameter = find_parameter(name);
  return parameter && parameter->fallback == Value();
}

/// The parameters that make settings different.
std::set<std::string> setting_parameters(const std::vector<PlacedRun>& runs) {
  std::map<std::string, std::vector<const PlacedRun*>> by_place;
  std::vector<const PlacedRun*> all;
  for (const PlacedRun& run : runs) {
    all.push_back(&run);
    by_place[place_of(run)].push_back(&run);
  }
  std::set<std::string> names = varying(all);
  std::erase_if(names, is_decided_by_scene);
  for (const auto& [_, same] : by_place) names.merge(varying(same));
  return names;
}

Arguments setting_of(const PlacedRun& run, const std::set<std::string>& parameters) {
  Arguments setting;
  for (const auto& [name, value] : run.values.all())
    if (parameters.contains(name) && !is_of_place(run, name)) setting.set(name, value);
  return setting;
}

/// Whether `whole` has all the values of `part`.
bool includes(const Arguments& whole, const Arguments& part) {
  return std::all_of(part.all().begin(), part.all().end(), [&](const Arguments::Argument& a) {
    return whole.contains(a.name) && whole[a.name] == a.value;
  });
}

/// The different settings of runs, without those that another one includes.
std::vector<Arguments> settings_of(const std::vector<Arguments>& of_runs) {
  std::vector<Arguments> settings;
  const auto is_included = [&](const Arguments& setting) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const Arguments& other) { return includes(other, setting); });
  };
  for (const Arguments& setting : of_runs) {
    if (is_included(setting)) continue;
    std::erase_if(settings, [&](const Arguments& other) { return includes(setting, other); });
    settings.push_back(setting);
  }
  return settings;
}

std::vector<InstructionEntry> instructions_of(const std::vector<NamedReport>& sources) {
  std::map<std::string, InstructionEntry> entries;
  for (const NamedReport& source : sources)
    for (const InstructionEntry& entry : source.report.instructions)
      entries.emplace(entry.mnemonic, entry);
  std::vector<InstructionEntry> list;
  for (const auto& [_, entry] : entries) list.push_back(entry);
  return list;
}

void add_run(Report& report, const PlacedRun& placed) {
  const Report& source = placed.source->report;
  const auto place = static_cast<std::size_t>(placed.run - source.runs.data());
  report.runs.push_back(*placed.run);
  report.timing.kernel_ms.push_back(source.kernel_ms(place).value_or(0.0));
}

}  // namespace

std::vector<Group> groups_of(const std::vector<NamedReport>& sources) {
  const std::vector<PlacedRun> runs = runs_of(sources);
  check_no_run_twice(runs);
  const std::set<std::string> parameters = setting_parameters(runs);
  std::vector<Arguments> of_runs;
  for (const PlacedRun& run : runs) of_runs.push_back(setting_of(run, parameters));
  std::vector<Group> groups;
  for (const Arguments& setting : settings_of(of_runs)) {
    Group& group = groups.emplace_back();
    group.name = text_of(setting);
    group.setting = setting;
    group.report.instructions = instructions_of(sources);
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (includes(setting, of_runs[i])) add_run(group.report, runs[i]);
  }
  return groups;
}

}  // namespace lanescope
