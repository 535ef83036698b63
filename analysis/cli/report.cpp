// SPDX-License-Identifier: MIT
// `lanescope report`: a page of charts from reports.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "analysis/cli/command.h"
#include "analysis/cli/input.h"
#include "analysis/cli/output.h"
#include "analysis/html/page.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Arguments {
  std::vector<std::string> files;
  std::string output;
  std::string frames;
};

/// Where the pictures are: as asked, or beside the first report.
std::string frames_directory(const Arguments& arguments) {
  if (!arguments.frames.empty()) {
    if (!std::filesystem::is_directory(arguments.frames))
      throw InputError("--frames", "'{}' is not a directory", arguments.frames);
    return arguments.frames;
  }
  const std::string beside = std::filesystem::path(arguments.files.front()).parent_path();
  return beside.empty() ? "." : beside;
}

void report(const Arguments& arguments) {
  if (arguments.files.empty())
    throw InputError("report", "of what? Name a report, as `run --json` writes it");
  if (arguments.output.empty()) throw InputError("--output", "is missing; name an HTML file");
  const std::string frames = frames_directory(arguments);
  Destination page(arguments.output);
  page.write(report_page(read_reports(arguments.files), frames));
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("reports", arguments->files, "Reports: the JSON of run or tables")
      ->type_name("FILE");
  app.add_option("-o,--output", arguments->output, "The page, an HTML file; - for standard output")
      ->type_name("FILE")
      ->group("Output");
  app.add_option("--frames", arguments->frames,
                 "Where the pictures frame-<scene>.png are; beside the first report if left out")
      ->type_name("DIR")
      ->group("Output");
  return [arguments] { report(*arguments); };
}

}  // namespace

extern const Command c_report{
    "report", "Writes a page of charts from reports",
    "  lanescope report out/report.json -o out/report.html\n"
    "  lanescope report out/report.json other.json --frames out -o both.html",
    declare};

}  // namespace lanescope
