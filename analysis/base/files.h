// SPDX-License-Identifier: MIT
// Whole files: read at once, written so that no half of one is ever seen where that can be had.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>
#include <string_view>

#include "analysis/base/temporary_file.h"

namespace lanescope {

/// The contents of a file. Throws InputError if it cannot be read.
std::string read_file(const std::string& path);

/// Output under a name. What is there decides how it is written:
///
///   nothing, or a file      to a temporary file beside it, which gets the name once it is whole:
///                           the file appears whole or not at all. A symbolic link stays and the
///                           file that it points to is written; a file keeps its permissions
///   a file where a rename   in place, from its beginning (a mount point; a directory that nothing
///     is refused            may be added to)
///   where standard output   through that descriptor
///     or error already go
///   a device, pipe, socket  piece by piece, as it comes; it stays what it is
///
/// Opening it early finds an unwritable place before the work is done; for a named pipe, it waits
/// for a reader.
class OutputFile {
 public:
  /// Throws InputError for what cannot be written, such as a directory.
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes the temporary file unless it was committed.
  ~OutputFile();

  const std::string& path() const { return path_; }
  /// Whether this is where standard output goes.
  bool is_standard_output() const { return is_standard_output_; }
  /// Writes more of the contents. Throws InputError if that fails. Requires that it is not
  /// committed.
  void append(std::string_view contents);
  /// Writes the rest of the contents and gives the file its name. Throws InputError if either
  /// fails; the old file, if any, is then untouched unless it is written in place. Requires that it
  /// is called once.
  void commit(std::string_view rest = {});

 private:
  void open_file(const struct stat* there);
  void copy_to_target() const;
  [[noreturn]] void fail() const;

  std::string path_;
  std::string target_;  ///< Where symbolic links lead.
  std::optional<TemporaryFile> temporary_;
  int descriptor_ = -1;            ///< That of the temporary file, or one of our own.
  bool has_old_contents_ = false;  ///< Written in place, and nothing has been written yet.
  bool is_standard_output_ = false;
  bool is_committed_ = false;
};

/// Writes a file as OutputFile does. Throws InputError if that fails.
void write_file(const std::string& path, std::string_view contents);

/// Creates a directory and its parents where they are missing. Throws InputError if that fails.
void make_directory(const std::string& path);

}  // namespace lanescope
