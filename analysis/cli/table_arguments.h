// SPDX-License-Identifier: MIT
// The options of commands that print tables of a report.
#pragma once

#include <string>
#include <vector>

#include "analysis/cli/options.h"
#include "analysis/formats/format.h"
#include "analysis/tables/table.h"

namespace lanescope {

/// What the options hold.
struct TableArguments {
  std::string format = "text";
  std::vector<std::string> tables;
  bool per_scene = false;
};

/// What is asked for.
struct TableRequest {
  const Format* format = nullptr;  ///< Null for a document of the command's own.
  std::vector<const Table*> tables;
  bool per_scene = false;
};

/// Declares the options. `own_format` is the word for a document of the command's own, or empty.
void add_table_options(CommandOptions& options, TableArguments& arguments,
                       const std::string& own_format = "");

/// The request among these tables; all of them if none is named. Throws InputError for names that
/// there are not, and for a choice of tables beside a document of the command's own, which is
/// whole.
TableRequest resolve_tables(const TableArguments& arguments,
                            const std::vector<const Table*>& tables,
                            const std::string& own_format = "");

/// The tables that have figures: of the view, then, if asked for, of each scene of its report by
/// itself.
std::vector<TableData> build(const TableRequest& request, const ReportView& view);

}  // namespace lanescope
