// SPDX-License-Identifier: MIT
#include "analysis/cli/machine_arguments.h"

#include <algorithm>

#include "analysis/cli/values.h"

namespace lanescope {
namespace {

constexpr std::string_view kJson = "json";

std::vector<std::string> format_names() {
  std::vector<std::string> names = names_of(formats());
  names.emplace_back(kJson);
  return names;
}

}  // namespace

void add_machine_options(CommandOptions& options, MachineArguments& arguments) {
  options.add_output_list({"--machine", "NAME|FILE",
                           "Only this machine (lanescope list machines), or that which a file "
                           "describes; repeatable"},
                          arguments.machines);
  options.add_output({"--format", "FORMAT", list_or(format_names())}, arguments.format);
}

MachineRequest resolve_machines(const MachineArguments& arguments) {
  MachineRequest request;
  const std::string format = parse_name({"--format", arguments.format}, "a format", format_names());
  if (format != kJson) request.format = &find_format(format);
  for (const std::string& wanted : arguments.machines) {
    MachineDescription machine = machine_of("--machine", wanted);
    const auto is_same = [&](const MachineDescription& other) {
      return other.name == machine.name;
    };
    if (std::any_of(request.machines.begin(), request.machines.end(), is_same))
      throw InputError("--machine", "two machines are named '{}'; each needs a name of its own",
                       machine.name);
    request.machines.push_back(std::move(machine));
  }
  if (request.machines.empty()) request.machines = shipped_machines();
  return request;
}

std::vector<Group> counted_groups(const NamedReport& report) {
  NamedReport counted = report;
  std::vector<double> kernel_ms;
  counted.report.runs.clear();
  for (std::size_t i = 0; i < report.report.runs.size(); ++i) {
    if (report.report.runs[i].stages.empty()) continue;
    counted.report.runs.push_back(report.report.runs[i]);
    kernel_ms.push_back(report.report.kernel_ms(i).value_or(0.0));
  }
  counted.report.timing.kernel_ms = std::move(kernel_ms);
  if (counted.report.runs.empty())
    throw InputError(report.name, "has no run that counted instructions");
  return groups_of({counted});
}

}  // namespace lanescope
