// SPDX-License-Identifier: MIT
// `lanescope machines`: what the runs of a report take on machines.
#include <fmt/format.h>

#include <memory>

#include "analysis/base/json_text.h"
#include "analysis/cli/input.h"
#include "analysis/cli/machine_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/machines/cost_tables.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

struct Given {
  std::string report;
  MachineArguments machines;
};

std::vector<TableData> tables_of(const std::vector<Group>& groups, const MachineRequest& request) {
  SequenceTrials trials;
  std::vector<TableData> all;
  for (const Group& group : groups)
    for (const MachineDescription& machine : request.machines) {
      const ReportCosts costs(group.report, machine, trials);
      TableData& table = all.emplace_back(cost_table(ReportView(group.report), costs));
      if (!group.name.empty()) table.caption += "; " + group.name;
    }
  return all;
}

/// The machines with the costs of all runs, whatever their settings.
std::string document(const Report& report, const MachineRequest& request) {
  SequenceTrials trials;
  Json machines = Json::array();
  for (const MachineDescription& machine : request.machines)
    machines.push_back(cost_json(report, ReportCosts(report, machine, trials)));
  return json_text(Json{{"machines", std::move(machines)}});
}

void show(const Given& given) {
  const MachineRequest request = resolve_machines(given.machines);
  if (given.report.empty()) throw InputError("machines", "of what? Name a report");
  const NamedReport report = read_reports({given.report}).front();
  const std::vector<Group> groups = counted_groups(report);
  print(request.format ? request.format->write(tables_of(groups, request))
                       : document(report.report, request));
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_argument({"report", "REPORT", "A report, as --json writes it"}, given->report);
  add_machine_options(options, given->machines);
  return [given] { show(*given); };
}

}  // namespace

extern const Command c_machines{
    "machines", "Prints what the runs of a report take on machines, in issue slots",
    "  lanescope machines report.json\n"
    "  lanescope machines report.json --machine avx2 --machine avx512-zen4\n"
    "  lanescope machines report.json --machine mine.json --format json",
    declare};

}  // namespace lanescope
