// SPDX-License-Identifier: MIT
#include "analysis/cli/table_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/cli/values.h"

namespace lanescope {
namespace {

std::vector<std::string> format_names(const std::string& own_format) {
  std::vector<std::string> names = names_of(formats());
  if (!own_format.empty()) names.push_back(own_format);
  return names;
}

}  // namespace

void add_table_options(CommandOptions& options, TableArguments& arguments,
                       const std::string& own_format) {
  options.add_output({"--format", "FORMAT", list_or(format_names(own_format))}, arguments.format);
  options.add_output_list(
      {"--table", "NAME", "Only this table (lanescope list tables); repeatable"}, arguments.tables);
  options.add_output_flag("--per-scene", "Also the tables of each scene by itself",
                          arguments.per_scene);
}

TableRequest resolve_tables(const TableArguments& arguments,
                            const std::vector<const Table*>& tables,
                            const std::string& own_format) {
  TableRequest request;
  request.per_scene = arguments.per_scene;
  const std::string format =
      parse_name({"--format", arguments.format}, "a format", format_names(own_format));
  for (const std::string& wanted : arguments.tables) {
    const std::string name = parse_name({"--table", wanted}, "a table", names_of(tables));
    request.tables.push_back(*std::find_if(
        tables.begin(), tables.end(), [&](const Table* table) { return table->name == name; }));
  }
  if (format != own_format)
    request.format = &find_format(format);
  else if (request.per_scene || !request.tables.empty())
    throw InputError("--format",
                     "{} holds all tables of the mean; leave out --table and --per-scene", format);
  if (request.tables.empty()) request.tables = tables;
  return request;
}

std::vector<TableData> build(const TableRequest& request, const ReportView& view) {
  std::vector<TableData> data = build_tables(request.tables, view);
  if (!request.per_scene) return data;
  for (const std::string& scene : scenes_of(view.report()))
    for (TableData& table : build_tables(request.tables, ReportView(view.report(), scene)))
      data.push_back(std::move(table));
  return data;
}

}  // namespace lanescope
