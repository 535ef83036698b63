// SPDX-License-Identifier: MIT
// The words of an OBJ file: what a line, a blank, a comment and a number are.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lanescope {

/// Walks through the statements of a text, and through the words of each.
///
/// A line ends in LF, CR LF or CR. Blanks are space, tab, form feed and vertical tab; a byte order
/// mark at the beginning of a line is one, too. `#` begins a comment, at the end of a word also,
/// but not within `1.#QNAN`. A backslash at the end of a line, blanks aside, joins the next to it;
/// one in a comment does not.
class ObjWords {
 public:
  /// `text` must outlive the object.
  explicit ObjWords(std::string_view text)
      : at_(text.data()), end_(text.data() + text.size()), begin_(text.data()) {}

  /// Goes on to the next statement that has a word. False at the end of the text. Requires that the
  /// words of the last have been taken or skipped.
  bool next_statement();

  /// The next word of the statement; empty at its end.
  std::string_view word();

  /// Leaves out the rest of a statement.
  void skip_words();
  /// The same for names, which may end in a backslash: only one that stands alone joins lines.
  void skip_names();

  std::size_t line() const { return line_; }  ///< Of the statement, from 1.
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  void skip_blanks();
  void skip_line_end();
  const char* after_line_end(const char* line_end) const;
  const char* after_joint(const char* backslash) const;

  const char* at_;
  const char* end_;
  const char* begin_;
  std::size_t line_ = 1;
  std::size_t line_here_ = 1;  ///< Later than line_ where lines are joined.
};

/// A word as a number: not a number and infinities for what printf writes for them on various
/// systems (`nan`, `-nan(ind)`, `1.#QNAN`, `inf`), zero where it is too small for a double,
/// infinite where it is too large. Nothing if it is no number.
std::optional<double> obj_number(std::string_view word);

/// A word as it can be shown in a message: short, and without control characters.
std::string shown(std::string_view word);

}  // namespace lanescope
