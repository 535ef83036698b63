// SPDX-License-Identifier: MIT
#include "workloads/geometry/obj_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lanescope {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether `#` goes on with `number` in the words that Microsoft's library has for what is no
/// number: `1.#QNAN`, `-1.#IND00`, also cut and rounded to fewer digits: `1.#QO`.
bool is_special(std::string_view number, std::string_view from_hash) {
  return (number == "1." || number == "-1." || number == "+1.") && from_hash.size() > 1 &&
         is_letter(from_hash[1]);
}

double special_value(std::string_view from_hash) {
  const bool infinite = from_hash.starts_with("#INF") || from_hash.starts_with("#inf");
  return infinite ? std::numeric_limits<double>::infinity()
                  : std::numeric_limits<double>::quiet_NaN();
}

/// Of a number that is no double: whether it is too large, and not too small. Its first digit other
/// than 0 stands before or after the point, and the exponent moves it.
bool is_large(std::string_view word) {
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  const std::size_t point = std::min(word.substr(0, end).find('.'), end);
  const std::size_t digit = std::min(word.find_first_of("123456789"), end);
  std::int64_t exponent = 0;
  std::string_view power = word.substr(std::min(end + 1, word.size()));
  if (power.starts_with('+')) power.remove_prefix(1);
  const auto [stop, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
  if (error == std::errc::result_out_of_range) return !power.starts_with('-');
  return exponent + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(digit) > 0;
}

}  // namespace

bool ObjWords::next_statement() {
  for (;;) {
    line_ = line_here_;
    if (between(at_, end_).starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
    skip_blanks();
    if (at_ == end_) return false;
    if (*at_ == '#') at_ = std::find_if(at_, end_, is_line_end);
    if (at_ != end_ && !is_line_end(*at_)) return true;
    skip_line_end();
  }
}

std::string_view ObjWords::word() {
  skip_blanks();
  const char* const begin = at_;
  for (; at_ != end_; ++at_) {
    if (is_blank(*at_) || is_line_end(*at_)) break;
    if (*at_ == '\\' && after_joint(at_)) break;
    if (*at_ == '#' && !is_special(between(begin, at_), between(at_, end_))) break;
  }
  const std::string_view word = between(begin, at_);
  if (word.empty()) {
    at_ = std::find_if(at_, end_, is_line_end);  // A comment.
    skip_line_end();
  }
  return word;
}

void ObjWords::skip_words() {
  while (!word().empty()) {
  }
}

void ObjWords::skip_names() {
  for (bool after_blank = false; at_ != end_ && !is_line_end(*at_);) {
    const char* const next = after_blank && *at_ == '\\' ? after_joint(at_) : nullptr;
    if (next) ++line_here_;
    after_blank = next || is_blank(*at_);
    at_ = next ? next : at_ + 1;
  }
  skip_line_end();
}

void ObjWords::skip_blanks() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (const char* const next = *at_ == '\\' ? after_joint(at_) : nullptr) {
      at_ = next;
      ++line_here_;
    } else {
      return;
    }
  }
}

void ObjWords::skip_line_end() {
  if (at_ == end_) return;
  at_ = after_line_end(at_);
  ++line_here_;
}

/// What follows a line end, which may be two characters.
const char* ObjWords::after_line_end(const char* line_end) const {
  const bool two = *line_end == '\r' && line_end + 1 != end_ && line_end[1] == '\n';
  return line_end + (two ? 2 : 1);
}

/// The beginning of the line that a backslash joins; null if it joins none.
const char* ObjWords::after_joint(const char* backslash) const {
  const char* const line_end = std::find_if_not(backslash + 1, end_, is_blank);
  if (line_end == end_) return end_;
  if (!is_line_end(*line_end)) return nullptr;
  return after_line_end(line_end);
}

std::optional<double> obj_number(std::string_view word) {
  if (word.starts_with('+') && !word.substr(1).starts_with('-')) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range) {
    const double size = is_large(word.substr(word.starts_with('-') ? 1 : 0))
                            ? std::numeric_limits<double>::infinity()
                            : 0.0;
    value = word.starts_with('-') ? -size : size;
  }
  if (stop == end) return value;
  const std::string_view rest = between(stop, end);
  if (std::isnan(value) && rest.starts_with('(') && rest.ends_with(')')) return value;
  if (rest.starts_with('#') && is_special(between(word.data(), stop), rest))
    return special_value(rest);
  return {};
}

std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 24;
  std::string text(word.substr(0, kLongest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return word.size() > kLongest ? text + "..." : text;
}

}  // namespace lanescope
