// SPDX-License-Identifier: MIT
// `lanescope report`: a page of charts from reports.
#include <filesystem>
#include <memory>

#include "analysis/cli/input.h"
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/html/page.h"
#include "analysis/studies/study.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

struct Given {
  std::vector<std::string> files;
  std::string output;
  std::string frames;
};

/// Where the pictures are: as asked, or beside the first report.
std::string frames_directory(const Given& given) {
  if (!given.frames.empty()) {
    if (!std::filesystem::is_directory(given.frames))
      throw InputError("--frames", "'{}' is not a directory", given.frames);
    return given.frames;
  }
  const std::string beside = std::filesystem::path(given.files.front()).parent_path();
  return beside.empty() ? "." : beside;
}

void report(const Given& given) {
  if (given.files.empty())
    throw InputError("report", "of what? Name a report, as `run --json` writes it");
  if (given.output.empty()) throw InputError("--output", "is missing; name an HTML file");
  const std::string frames = frames_directory(given);
  Destination page(given.output);
  const std::vector<NamedReport> sources = read_reports(given.files);
  page.write(report_page(sources, frames,
                         [](const Report& setting) { return page_plan(setting, studies()); }));
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_arguments({"reports", "FILE", "Reports: the JSON of run or of a study"},
                        given->files);
  options.add_output({"-o,--output", "FILE", "The page, an HTML file; - for standard output"},
                     given->output);
  options.add_output({"--frames", "DIR",
                      "Where the pictures frame-<scene>.png are; beside the first report if left "
                      "out"},
                     given->frames);
  return [given] { report(*given); };
}

}  // namespace

extern const Command c_report{
    "report", "Writes a page of charts from reports",
    "  lanescope report out/report.json -o out/report.html\n"
    "  lanescope report out/report.json other.json --frames out -o both.html",
    declare};

}  // namespace lanescope
