// SPDX-License-Identifier: MIT
// The directory of a sweep: one report for each finished cell, named by what identifies the cell.
// Several processes may work on one directory, as every file appears whole or not at all.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// 16 hexadecimal digits that identify a cell: a hash of its resolved parameters, of the version
/// and commit of the program, and, if its scene is a file that can be read, of the file's content.
/// Requires that the program has the cell's kernel.
std::string cell_id(const Configuration& cell);

class SweepDirectory {
 public:
  /// Does not look at the directory yet.
  explicit SweepDirectory(std::string path) : path_(std::move(path)) {}

  /// Makes the directory, and removes what killed processes of this host left half-written. Throws
  /// InputError if the directory cannot be made.
  void open() const;

  /// The cell's report; none if there is no such file, or it is not a report of just this cell.
  std::optional<Report> find(const Configuration& cell) const;
  /// Whether the cell failed when it was last tried.
  bool has_failed(const Configuration& cell) const;

  /// Keeps the report of a cell and forgets its failure. Throws InputError if it cannot be written.
  void keep(const Configuration& cell, const Report& report) const;
  /// Keeps what went wrong with a cell, with its parameters.
  void keep_failure(const Configuration& cell, std::string_view error) const;

  /// The files of all cells, whatever sweep they belong to, in the order of their names.
  std::vector<std::string> cell_files() const;
  std::size_t failure_count() const;

  const std::string& path() const { return path_; }
  std::string cells_path() const { return path_ + "/cells"; }
  std::string failed_path() const { return path_ + "/failed"; }

 private:
  std::string cell_path(const Configuration& cell) const;
  /// Whatever the content of its scene was: a file that is mended leaves no failure behind.
  std::string failure_path(const Configuration& cell) const;
  std::string path_;
};

}  // namespace lanescope
