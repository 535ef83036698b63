// SPDX-License-Identifier: MIT
// Where results and messages go: standard output, files, standard error.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/base/files.h"

namespace lanescope {

/// Whoever read standard output reads no more. This is nobody's mistake: the program ends quietly.
class ClosedPipe : public std::runtime_error {
 public:
  ClosedPipe() : std::runtime_error("standard output: cannot be written: Broken pipe") {}
};

/// Writes to standard output. Throws InputError if it cannot take it (a full disk), and ClosedPipe
/// if nobody takes it any more.
void print(std::string_view text);

/// Writes a line to standard error, after the name of the program; control characters are escaped.
/// What cannot be written is dropped: no result depends on it.
void tell(std::string_view line);

/// A place for a document: standard output (`-`), a file, or none (an empty path). A file is opened
/// at once, so that an unwritable place is found before the work; see OutputFile.
class Destination {
 public:
  explicit Destination(const std::string& path);
  /// Also if it is named as a file: `/dev/stdout`.
  bool is_stdout() const { return is_stdout_ || (file_ && file_->is_standard_output()); }
  bool is_none() const { return !is_stdout_ && !file_; }
  /// Writes more of the document; a file appears with write().
  void append(std::string_view text);
  /// Writes the rest of the document, or all of it.
  void write(std::string_view text = {});

 private:
  bool is_stdout_;
  std::unique_ptr<OutputFile> file_;
};

/// Makes every output, whatever becomes of the others, and then throws what the first of those that
/// failed threw.
void make_all(const std::vector<std::function<void()>>& outputs);

}  // namespace lanescope
