// SPDX-License-Identifier: MIT
// Files that go away unless they get their final name, even where a signal ends the process.
#pragma once

#include <cstddef>
#include <string>

namespace lanescope {

/// A new file beside the one that it will become, named after it and this process. Its descriptor
/// is open for writing.
class TemporaryFile {
 public:
  /// Throws InputError if this process is writing a file of that name already, and
  /// std::system_error if the file cannot be created.
  explicit TemporaryFile(const std::string& target);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  /// Closes and removes the file, unless it was renamed.
  ~TemporaryFile();

  int descriptor() const { return descriptor_; }
  const std::string& path() const { return path_; }
  /// Gives the file the name of its target. Returns false, with errno, if that is refused; then it
  /// stays a temporary one.
  bool rename_to_target();

 private:
  std::string target_;
  std::string path_;
  std::size_t slot_;  ///< In the list of what remove_temporary_files() removes.
  int descriptor_ = -1;
};

/// Removes every temporary file of this process. May be called by a signal handler; the process
/// must then end.
void remove_temporary_files() noexcept;

/// Removes the temporary files that killed processes of this host left in a directory. Files of
/// processes that still run stay, and so does everything if there is no such directory.
void remove_dead_temporaries(const std::string& directory);

}  // namespace lanescope
