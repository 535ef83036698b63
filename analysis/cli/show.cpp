// SPDX-License-Identifier: MIT
// `lanescope show`: the tables that any report has.
#include <memory>

#include "analysis/cli/input.h"
#include "analysis/cli/output.h"
#include "analysis/cli/table_arguments.h"
#include "analysis/html/groups.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Given {
  std::string report;
  TableArguments tables;
};

/// The tables of each setting of the report: a table compares runs that differ in nothing else.
std::vector<TableData> tables_of(const std::vector<NamedReport>& sources,
                                 const TableRequest& request) {
  std::vector<TableData> all;
  for (const Group& group : groups_of(sources))
    for (TableData& table : build(request, ReportView(group.report))) {
      if (!group.name.empty()) table.caption += "; " + group.name;
      all.push_back(std::move(table));
    }
  return all;
}

void show(const Given& given) {
  const TableRequest request = resolve_tables(given.tables, tables());
  if (given.report.empty()) throw InputError("show", "of what? Name a report");
  const std::vector<TableData> data = tables_of(read_reports({given.report}), request);
  if (data.empty()) throw InputError(given.report, "has no figures for these tables");
  print(request.format->write(data));
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_argument({"report", "REPORT", "A report, as --json writes it"}, given->report);
  add_table_options(options, given->tables);
  return [given] { show(*given); };
}

}  // namespace

extern const Command c_show{"show", "Prints tables of a report: those that any kernel has",
                            "  lanescope show report.json\n"
                            "  lanescope show report.json --table utilization --table mix\n"
                            "  lanescope show out/report.json --format markdown --per-scene",
                            declare};

}  // namespace lanescope
