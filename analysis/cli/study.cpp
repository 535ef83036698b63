// SPDX-License-Identifier: MIT
// `lanescope study`: the experiments of papers.
#include <fmt/format.h>

#include "analysis/cli/lists.h"
#include "analysis/cli/output.h"
#include "analysis/cli/study_command.h"

namespace lanescope {
namespace {

Action declare(CommandOptions& options) {
  options.call_commands("study");
  for (const Study* study : studies())
    options.add_command(
        study->name, study->summary,
        fmt::format("  lanescope study {0} --out out\n"
                    "  lanescope study {0} --table {1}\n"
                    "  lanescope study {0} --from out/report.json --format latex --per-scene",
                    study->name, study->tables().back()->name),
        [study](CommandOptions& below) { return declare_study(below, *study); });
  return [&options]() -> int {
    if (const auto status = options.run_command()) return *status;
    print(list_studies());
    return 0;
  };
}

}  // namespace

extern const Command c_study{"study",
                             "Runs the experiment of a paper and prints its tables beside ours; "
                             "lists the studies if none is named",
                             "  lanescope study\n"
                             "  lanescope study {study} --help\n"
                             "  lanescope study {study} --out out",
                             declare};

}  // namespace lanescope
