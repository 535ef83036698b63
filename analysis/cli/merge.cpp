// SPDX-License-Identifier: MIT
// `lanescope merge`: one report from several, or from the cells of sweeps.
#include "analysis/report/merge.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "analysis/cli/input.h"
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/report/report_json.h"
#include "analysis/sweep/sweep_directory.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Given {
  std::vector<std::string> inputs;
  std::string output;
};

/// The cells of a sweep's directory. Says so if some have failed, as the report will lack them.
std::vector<std::string> cells_of(const std::string& path) {
  const SweepDirectory directory(path);
  std::vector<std::string> files = directory.cell_files();
  if (files.empty())
    throw InputError(path, "has no reports in {}; name the directory of a sweep",
                     directory.cells_path());
  if (const std::size_t failures = directory.failure_count(); failures > 0)
    tell(fmt::format("{}: {} failed and {} not in the report; see {}/", path,
                     failures == 1 ? "1 cell" : fmt::format("{} cells", failures),
                     failures == 1 ? "is" : "are", directory.failed_path()));
  return files;
}

void merge(const CommandOptions& command, const Given& given) {
  if (given.inputs.empty()) throw InputError("merge", "name reports, or directories of sweeps");
  if (given.output.empty()) throw InputError("--output", "is missing; name a file");
  std::vector<std::string> files;
  for (const std::string& input : given.inputs) {
    std::error_code unreadable;
    const bool is_sweep = std::filesystem::is_directory(input, unreadable);
    const std::vector<std::string> more = is_sweep ? cells_of(input) : std::vector{input};
    files.insert(files.end(), more.begin(), more.end());
  }
  Destination output(given.output);
  Report merged = merge_reports(read_reports(files));
  merged.command = command.command_line();
  output.write(report_text(merged));
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_arguments({"inputs", "FILE-OR-DIR", "Reports, and directories of sweeps"},
                        given->inputs);
  options.add_output({"-o,--output", "FILE", "The report; - for standard output"}, given->output);
  return [&options, given] { merge(options, *given); };
}

}  // namespace

extern const Command c_merge{"merge", "Makes one report of several, or of the cells of sweeps",
                             "  lanescope merge cells -o report.json\n"
                             "  lanescope merge report.json cells -o all.json",
                             declare};

}  // namespace lanescope
