// SPDX-License-Identifier: MIT
// Where results go: standard output or files that appear whole.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "analysis/base/files.h"

namespace lanescope {

/// Writes to standard output. Throws InputError if it cannot take it (a full disk).
void print(std::string_view text);

/// A place for a document: standard output (`-`), a file, or none (an empty path). A file is opened
/// at once, so that an unwritable place is found before the work.
class Destination {
 public:
  explicit Destination(const std::string& path);
  bool is_stdout() const { return is_stdout_; }
  bool is_none() const { return !is_stdout_ && !file_; }
  /// Writes more of the document; a file appears with write().
  void append(std::string_view text);
  /// Writes the rest of the document, or all of it.
  void write(std::string_view text = {});

 private:
  bool is_stdout_;
  std::unique_ptr<AtomicFile> file_;
};

}  // namespace lanescope
