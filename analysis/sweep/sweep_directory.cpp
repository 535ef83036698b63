// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep_directory.h"

#include <algorithm>
#include <filesystem>

#include "analysis/base/build_info.h"
#include "analysis/base/files.h"
#include "analysis/base/json_text.h"
#include "analysis/base/printable.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/report_json.h"
#include "analysis/sweep/content_hash.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".json";
constexpr int kFailureVersion = 1;
constexpr std::string_view kFailureSchema = "lanescope-sweep-failure";

/// The files of a directory that end in .json, by name; none if there is no such directory.
std::vector<std::string> json_files(const std::string& directory) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (entry.path().extension() == kEnding) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A hash of the resolved parameters, the version and commit of the program, and `content`.
std::string identity(const Configuration& cell, std::string_view content) {
  return fmt::format("{:016x}",
                     text_hash(fmt::format("{}\n{}\n{}{}", configuration_json(cell).dump(),
                                           program_version(), program_commit(), content)));
}

}  // namespace

std::string cell_id(const Configuration& cell) {
  std::optional<std::uint64_t> content;
  if (workload_of(cell).is_file(cell.scene)) content = file_hash(cell.scene);
  return identity(cell, content ? fmt::format("\n{:016x}", *content) : "");
}

void SweepDirectory::open() const {
  make_directory(cells_path());
  for (const std::string& directory : {path_, cells_path(), failed_path()})
    remove_dead_temporaries(directory);
}

std::optional<Report> SweepDirectory::find(const Configuration& cell) const {
  try {
    Report report = read_report(cell_path(cell));
    if (report.runs.size() == 1 && report.runs.front().configuration == cell &&
        report.program_version == program_version() && report.commit == program_commit())
      return report;
  } catch (const InputError&) {
    // There is no file, or it is no report, which is as good as none: the cell is done again.
  }
  return std::nullopt;
}

bool SweepDirectory::has_failed(const Configuration& cell) const {
  std::error_code unreadable;
  return fs::exists(failure_path(cell), unreadable);
}

void SweepDirectory::keep(const Configuration& cell, const Report& report) const {
  write_file(cell_path(cell), report_text(report));
  std::error_code ignored;  // A failure that is not there cannot be removed.
  fs::remove(failure_path(cell), ignored);
}

void SweepDirectory::keep_failure(const Configuration& cell, std::string_view error) const {
  make_directory(failed_path());
  write_file(failure_path(cell),
             json_text({{"schema", {{"name", kFailureSchema}, {"version", kFailureVersion}}},
                        {"parameters", configuration_json(cell)},
                        {"error", printable(error)}}));
}

std::vector<std::string> SweepDirectory::cell_files() const { return json_files(cells_path()); }

std::size_t SweepDirectory::failure_count() const { return json_files(failed_path()).size(); }

std::string SweepDirectory::cell_path(const Configuration& cell) const {
  return fmt::format("{}/{}{}", cells_path(), cell_id(cell), kEnding);
}

std::string SweepDirectory::failure_path(const Configuration& cell) const {
  return fmt::format("{}/{}{}", failed_path(), identity(cell, ""), kEnding);
}

}  // namespace lanescope
