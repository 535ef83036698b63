// SPDX-License-Identifier: MIT
// `lanescope csv`: reports as tidy data for notebooks.
#include <CLI/CLI.hpp>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/input.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/report/tidy.h"

namespace lanescope {
namespace {

struct Arguments {
  std::vector<std::string> reports;
  std::string rows = "instructions";
  std::string output = "-";
};

void run(const Arguments& arguments) {
  const TidyRows rows = parse_choice({"--rows", arguments.rows}, kTidyRows);
  if (arguments.reports.empty()) throw InputError("csv", "of what? Name one or more reports");
  Destination output(arguments.output);
  const TidyTable table = tidy(read_reports(arguments.reports), rows);
  if (table.rows.empty())
    throw InputError("--rows", "there are no {} in these reports; use runs", arguments.rows);
  output.write(tidy_csv(table));
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("reports", arguments->reports, "Reports, as --json writes them")
      ->type_name("REPORT");
  app.add_option("--rows", arguments->rows, "A row is one of: instructions, stages, runs")
      ->type_name("OF")
      ->default_str(arguments->rows)
      ->group("Output");
  app.add_option("-o,--output", arguments->output, "Writes there; - for standard output")
      ->type_name("FILE")
      ->default_str(arguments->output)
      ->group("Output");
  return [arguments] { run(*arguments); };
}

}  // namespace

extern const Command c_csv{"csv", "Writes reports as tidy CSV for notebooks",
                           "  lanescope csv report.json\n"
                           "  lanescope csv out/report.json --rows stages -o stages.csv\n"
                           "  lanescope csv a.json b.json --rows runs",
                           declare};

}  // namespace lanescope
