// SPDX-License-Identifier: MIT
// Which cells of a directory are being run, so that several processes share its work.
#pragma once

#include <string>

namespace lanescope {

/// The claims of this process on cells, by their ids. A claim is a lock on one byte of a file of
/// the directory: the system takes it back when the process ends, however it ends, so that a dead
/// process claims nothing. Where a file system has no locks, every claim is granted, and cells may
/// be run twice.
class CellClaims {
 public:
  /// The name of the file, which stays empty.
  static constexpr const char* kFileName = "claims";

  /// Throws InputError if the file cannot be made.
  explicit CellClaims(const std::string& directory);
  CellClaims(const CellClaims&) = delete;
  CellClaims& operator=(const CellClaims&) = delete;
  /// Gives all claims back.
  ~CellClaims();

  /// Claims a cell. Returns false if another process has.
  bool take(const std::string& cell_id) const;
  void give_back(const std::string& cell_id) const;

 private:
  int descriptor_;
};

/// Whether some process has claimed the cell. Writes nothing.
bool is_claimed(const std::string& directory, const std::string& cell_id);

}  // namespace lanescope
