// SPDX-License-Identifier: MIT
#include "analysis/html/groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/configuration/configuration_json.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

struct PlacedRun {
  const NamedReport* source;
  const RunRecord* run;
  Json parameters;
};

std::vector<PlacedRun> runs_of(const std::vector<NamedReport>& sources) {
  std::vector<PlacedRun> runs;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs)
      runs.push_back({&source, &run, configuration_json(run.configuration)});
  return runs;
}

void check_no_run_twice(const std::vector<PlacedRun>& runs) {
  std::map<std::string, const PlacedRun*> seen;
  for (const PlacedRun& run : runs) {
    const auto [first, is_new] = seen.emplace(run.parameters.dump(), &run);
    if (is_new) continue;
    const Configuration& c = run.run->configuration;
    throw InputError(run.source->name,
                     "has a run that {} has, too: {} on {}, W = {}, {}; leave out one of the files",
                     first->second->source->name, c.kernel, c.scene, c.width, to_string(c.shape()));
  }
}

/// The values of some parameters, as a name: `edges = inline, seed = 1`.
std::string values_of(const Json& parameters, const std::vector<std::string>& names) {
  std::vector<std::string> texts;
  for (const std::string& name : names) {
    const Json& value = parameters.at(name);
    texts.push_back(
        fmt::format("{} = {}", name, value.is_string() ? value.get<std::string>() : value.dump()));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The parameters whose values are not the same in all of the runs.
std::set<std::string> varying(const std::vector<const PlacedRun*>& runs) {
  std::set<std::string> names;
  for (const PlacedRun* run : runs)
    for (const auto& [name, value] : run->parameters.items())
      if (value != runs.front()->parameters.at(name)) names.insert(name);
  return names;
}

/// The parameters that make settings different, in the order of parameters.
std::vector<std::string> setting_parameters(const std::vector<PlacedRun>& runs) {
  const std::vector<std::string> place{"kernel", "width_lanes", "micropolygon", "scene"};
  std::map<std::string, std::vector<const PlacedRun*>> by_place;
  std::vector<const PlacedRun*> all;
  for (const PlacedRun& run : runs) {
    all.push_back(&run);
    by_place[values_of(run.parameters, place)].push_back(&run);
  }
  std::set<std::string> names = varying(all);
  for (const std::string& name : place) names.erase(name);
  for (const char* of_scene : {"frame", "mesh_patches"}) names.erase(of_scene);
  for (const auto& [_, same] : by_place) names.merge(varying(same));
  std::vector<std::string> ordered;
  for (const auto& [name, _] : runs.front().parameters.items())
    if (names.contains(name)) ordered.push_back(name);
  return ordered;
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

}  // namespace

std::vector<Group> groups_of(const std::vector<NamedReport>& sources) {
  const std::vector<PlacedRun> runs = runs_of(sources);
  check_no_run_twice(runs);
  std::vector<Group> groups;
  if (runs.empty()) return groups;
  const std::vector<std::string> parameters = setting_parameters(runs);
  for (const PlacedRun& run : runs) {
    const std::string name = values_of(run.parameters, parameters);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& other) { return other.name == name; });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {name, {}});
      group->report.instructions = instructions_of(sources);
    }
    group->report.runs.push_back(*run.run);
  }
  return groups;
}

}  // namespace lanescope
