// SPDX-License-Identifier: MIT
// `lanescope merge`: one report from several, or from the cells of sweeps.
#include "analysis/report/merge.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/input.h"
#include "analysis/cli/output.h"
#include "analysis/report/report_json.h"
#include "analysis/sweep/sweep_directory.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Arguments {
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
    std::fputs(fmt::format("lanescope: {}: {} failed and {} not in the report; see {}/\n", path,
                           failures == 1 ? "1 cell" : fmt::format("{} cells", failures),
                           failures == 1 ? "is" : "are", directory.failed_path())
                   .c_str(),
               stderr);
  return files;
}

void merge(const CLI::App& app, const Arguments& arguments) {
  if (arguments.inputs.empty()) throw InputError("merge", "name reports, or directories of sweeps");
  if (arguments.output.empty()) throw InputError("--output", "is missing; name a file");
  std::vector<std::string> files;
  for (const std::string& input : arguments.inputs) {
    std::error_code unreadable;
    const bool is_sweep = std::filesystem::is_directory(input, unreadable);
    const std::vector<std::string> more = is_sweep ? cells_of(input) : std::vector{input};
    files.insert(files.end(), more.begin(), more.end());
  }
  Destination output(arguments.output);
  Report merged = merge_reports(read_reports(files));
  merged.command = command_of(app);
  output.write(report_text(merged));
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("inputs", arguments->inputs, "Reports, and directories of sweeps")
      ->type_name("FILE-OR-DIR");
  app.add_option("-o,--output", arguments->output, "The report; - for standard output")
      ->type_name("FILE")
      ->group("Output");
  return [&app, arguments] { merge(app, *arguments); };
}

}  // namespace

extern const Command c_merge{"merge", "Makes one report of several, or of the cells of sweeps",
                             "  lanescope merge cells -o report.json\n"
                             "  lanescope merge report.json cells -o all.json",
                             declare};

}  // namespace lanescope
