// SPDX-License-Identifier: MIT
// `lanescope csv`: reports as tidy data for notebooks.
#include <memory>

#include "analysis/cli/input.h"
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/report/tidy.h"

namespace lanescope {
namespace {

struct Given {
  std::vector<std::string> reports;
  std::string rows = "instructions";
  std::string output = "-";
};

void run(const Given& given) {
  const TidyRows rows = parse_choice({"--rows", given.rows}, kTidyRows);
  if (given.reports.empty()) throw InputError("csv", "of what? Name one or more reports");
  Destination output(given.output);
  const TidyTable table = tidy(read_reports(given.reports), rows);
  if (table.rows.empty())
    throw InputError("--rows", "there are no {} in these reports; use runs", given.rows);
  output.write(tidy_csv(table));
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_arguments({"reports", "REPORT", "Reports, as --json writes them"}, given->reports);
  options.add_output({"--rows", "OF", "A row is one of: " + list_or(names_of(kTidyRows))},
                     given->rows);
  options.add_output({"-o,--output", "FILE", "Writes there; - for standard output"}, given->output);
  return [given] { run(*given); };
}

}  // namespace

extern const Command c_csv{"csv", "Writes reports as tidy CSV for notebooks",
                           "  lanescope csv report.json\n"
                           "  lanescope csv out/report.json --rows stages -o stages.csv\n"
                           "  lanescope csv a.json b.json --rows runs",
                           declare};

}  // namespace lanescope
