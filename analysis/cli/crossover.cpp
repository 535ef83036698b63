// SPDX-License-Identifier: MIT
// `lanescope crossover`: from which width on one kernel takes less than another, on each machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "analysis/base/json_text.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/input.h"
#include "analysis/cli/machine_arguments.h"
#include "analysis/cli/narrated_experiment.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/machines/crossover_tables.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

struct Given {
  std::string from;
  ExperimentArguments experiment;
  std::string threads;
  std::string kernels;
  MachineArguments machines;
};

NamedReport run_report(const CommandOptions& command, const Given& given) {
  const std::vector<Configuration> configurations = resolve_configurations(given.experiment);
  ExperimentOptions options;
  options.threads = parse_threads(given.threads);
  Narration narration(command.name());
  return {"the report", run_narrated(narration, configurations, options)};
}

/// The two kernels to compare: those named, or the first two that issue instructions.
std::pair<std::string, std::string> chosen_kernels(const std::string& text,
                                                   const NamedReport& source) {
  const std::vector<std::string> there = vector_kernels(source.report);
  if (text.empty()) {
    if (there.size() < 2)
      throw InputError(source.name, "has {} that counted instructions; two are needed",
                       there.size() == 1 ? "one kernel" : "no kernel");
    return {there[0], there[1]};
  }
  std::vector<std::string> wanted;
  for (const Argument& kernel : parse_list({"--kernels", text}))
    wanted.push_back(parse_name(kernel, "a kernel that counted instructions", there));
  if (wanted.size() != 2)
    throw InputError("--kernels", "'{}' does not name two kernels, with a comma between them",
                     text);
  return {wanted[0], wanted[1]};
}

/// The crossovers of each setting of a report.
class Crossovers {
 public:
  Crossovers(const NamedReport& source, const std::string& kernels, const MachineRequest& request)
      : groups_(counted_groups(source)) {
    const auto [first, second] = chosen_kernels(kernels, source);
    for (const Group& group : groups_)
      all_.push_back(crossovers(ReportView(group.report), first, second, request.machines));
    if (std::all_of(all_.begin(), all_.end(), [](const auto& each) { return each.empty(); }))
      throw InputError(source.name, "has no runs of {} and {} on the same kind of their work",
                       first, second);
  }

  std::vector<TableData> tables() const {
    std::vector<TableData> tables;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (all_[i].empty()) continue;
      TableData& table =
          tables.emplace_back(crossover_table(ReportView(groups_[i].report), all_[i]));
      if (!groups_[i].name.empty()) table.caption += "; " + groups_[i].name;
    }
    return tables;
  }

  std::string document() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < groups_.size(); ++i)
      for (const MachineCrossover& one : all_[i]) {
        Json json = crossover_json(one);
        json["setting"] = groups_[i].name;
        list.push_back(std::move(json));
      }
    return json_text(Json{{"crossovers", std::move(list)}});
  }

 private:
  std::vector<Group> groups_;
  std::vector<std::vector<MachineCrossover>> all_;  ///< Of each group.
};

void show(const CommandOptions& command, const Given& given) {
  const MachineRequest request = resolve_machines(given.machines);
  const NamedReport source =
      given.from.empty() ? run_report(command, given) : read_reports({given.from}).front();
  const Crossovers crossovers(source, given.kernels, request);
  print(request.format ? request.format->write(crossovers.tables()) : crossovers.document());
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  add_experiment_options(options, given->experiment);
  add_threads_option(options, given->threads);
  options.exclude_all_before(options.add_output(
      {"--from", "FILE", "Reads a report instead of running kernels"}, given->from));
  options.add_output(
      {"--kernels", "A,B", "From where on B takes fewer slots than A; the first two of the report"},
      given->kernels);
  add_machine_options(options, given->machines);
  return [&options, given] { show(options, *given); };
}

}  // namespace

extern const Command c_crossover{
    "crossover", "Finds from which width on a kernel takes fewer slots than another",
    "  lanescope crossover --from out/report.json\n"
    "  lanescope crossover --from out/report.json --machine avx2 --format markdown\n"
    "  lanescope crossover --scene {scene} --width 8,16 --format json",
    declare};

}  // namespace lanescope
