// SPDX-License-Identifier: MIT
// Whole files: read at once, written atomically.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lanescope {

/// The contents of a file. Throws InputError if it cannot be read.
std::string read_file(const std::string& path);

/// A file that appears whole or not at all: text goes to a temporary name beside it, at once or
/// piece by piece, and commit() renames that. Opening it early finds an unwritable place before the
/// work is done.
class AtomicFile {
 public:
  /// Throws InputError if the temporary file cannot be created.
  explicit AtomicFile(std::string path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Removes the temporary file unless it was committed.
  ~AtomicFile();

  const std::string& path() const { return path_; }
  /// Writes more of the contents. Throws InputError if that fails. Requires that it is not
  /// committed.
  void append(std::string_view contents);
  /// Writes the rest of the contents and gives the file its name. Throws InputError if either
  /// fails; the old file, if any, is then untouched. Requires that it is called once.
  void commit(std::string_view rest = {});

 private:
  std::string path_;
  std::string temporary_path_;
  int descriptor_ = -1;
};

/// Writes a file atomically. Throws InputError if that fails.
void write_file(const std::string& path, std::string_view contents);

/// Removes the temporary files that AtomicFile left in a directory when its process was killed.
/// Files of processes that still run stay, and so does everything if there is no such directory.
void remove_dead_temporaries(const std::string& directory);

/// Creates a directory and its parents where they are missing. Throws InputError if that fails.
void make_directory(const std::string& path);

}  // namespace lanescope
