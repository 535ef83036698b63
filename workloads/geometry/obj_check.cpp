// SPDX-License-Identifier: MIT
#include "workloads/geometry/obj_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Words = std::vector<std::string_view>;

const std::vector<std::string>& keywords() {
  static const std::vector<std::string> all = {
      "v",         "vt",       "vn",       "vp",     "f",      "g",      "o",      "s",
      "l",         "p",        "mg",       "usemtl", "mtllib", "usemap", "maplib", "bevel",
      "lod",       "end",      "curv",     "curv2",  "surf",   "parm",   "trim",   "hole",
      "scrv",      "sp",       "con",      "deg",    "bmat",   "step",   "cstype", "shadow_obj",
      "trace_obj", "c_interp", "d_interp", "ctech",  "stech"};
  return all;
}

Words words_of(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r\f\v";
  Words words;
  std::size_t begin = line.find_first_not_of(kSpace);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSpace, end);
  }
  return words;
}

/// A word as it can be shown in a message: short, and without control characters.
std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 24;
  std::string text(word.substr(0, kLongest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return word.size() > kLongest ? text + "..." : text;
}

/// Parses the whole of a word.
template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && stop == end && !word.empty();
}

/// An index of a face that points past what has been read so far, to be checked at the end.
struct Forward {
  std::int64_t index;
  std::size_t line;
};

class Checker {
 public:
  explicit Checker(std::string_view path) : path_(path) {}

  void line(std::string_view text) {
    ++line_;
    if (text.find('\0') != std::string_view::npos)
      throw InputError(path_, "is not a text file; use a Wavefront OBJ file");
    const Words words = words_of(text.substr(0, text.find('#')));
    if (words.empty()) return;
    if (words.back().ends_with('\\'))
      fail("a line that goes on with '\\' cannot be read; join it with the next");
    statement(words);
  }

  void finish() {
    if (vertices_ == 0) throw InputError(path_, "has no vertices; a mesh needs lines 'v x y z'");
    if (faces_ == 0) throw InputError(path_, "has no faces; a mesh needs lines 'f a b c'");
    check_forward(forward_vertices_, vertices_, "vertex", "vertices");
    check_forward(forward_normals_, normals_, "normal", "normals");
  }

 private:
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw InputError(fmt::format("{}:{}", path_, line_), format, std::forward<Args>(args)...);
  }

  void statement(const Words& words) {
    const std::string keyword(words[0]);
    if (keyword == "v") {
      coordinates(words, "vertex", "v x y z");
      ++vertices_;
    } else if (keyword == "vn") {
      coordinates(words, "normal", "vn x y z");
      ++normals_;
    } else if (keyword == "f") {
      face(words);
    } else if (std::find(keywords().begin(), keywords().end(), keyword) == keywords().end()) {
      fail("'{}' is not a statement of an OBJ file{}", shown(keyword),
           did_you_mean(keyword, keywords()));
    }
  }

  void coordinates(const Words& words, std::string_view what, std::string_view form) const {
    if (words.size() < 4) fail("a {} of {} coordinates; use '{}'", what, words.size() - 1, form);
    for (std::size_t i = 1; i < words.size(); ++i) {
      float value = 0.0f;
      if (!parse(words[i], value)) fail("'{}' is not a number", shown(words[i]));
      if (!std::isfinite(value)) fail("'{}' is not a finite coordinate", shown(words[i]));
    }
  }

  void face(const Words& words) {
    if (words.size() < 4) fail("a face of {} corners; use 3 or more", words.size() - 1);
    for (std::size_t i = 1; i < words.size(); ++i) corner(words[i]);
    ++faces_;
  }

  /// A corner is vertex, vertex/texture, vertex//normal or vertex/texture/normal.
  void corner(std::string_view word) {
    std::string_view rest = word;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = rest.find('/');
      const std::string_view text = rest.substr(0, slash);
      const bool may_be_empty = part == 1 && slash != std::string_view::npos;
      if (!(text.empty() && may_be_empty)) index(word, text, part);
      if (slash == std::string_view::npos) return;
      rest.remove_prefix(slash + 1);
    }
    fail("'{}' is not a corner of a face; use v, v/t, v//n or v/t/n", shown(word));
  }

  void index(std::string_view word, std::string_view text, int part) {
    std::int64_t value = 0;
    if (!parse(text, value))
      fail("'{}' is not a corner of a face; use v, v/t, v//n or v/t/n", shown(word));
    if (value == 0) fail("index 0 in '{}'; indices start at 1", shown(word));
    if (part == 0)
      range(value, vertices_, "vertex", "vertices", forward_vertices_);
    else if (part == 2)
      range(value, normals_, "normal", "normals", forward_normals_);
  }

  void range(std::int64_t index, std::int64_t count, std::string_view one, std::string_view many,
             std::vector<Forward>& forward) const {
    if (-index > count) fail("{} {} counts back past the first of {} {}", one, index, count, many);
    if (index > count) forward.push_back({index, line_});
  }

  void check_forward(const std::vector<Forward>& all, std::int64_t count, std::string_view one,
                     std::string_view many) {
    for (const Forward& f : all)
      if (f.index > count) {
        line_ = f.line;
        fail("{} {} of a face, but the file has {} {}", one, f.index, count, many);
      }
  }

  std::string_view path_;
  std::size_t line_ = 0;
  std::int64_t vertices_ = 0;
  std::int64_t normals_ = 0;
  std::int64_t faces_ = 0;
  std::vector<Forward> forward_vertices_;
  std::vector<Forward> forward_normals_;
};

}  // namespace

void check_obj(std::string_view text, std::string_view path) {
  if (text.empty()) throw InputError(path, "is empty; use a Wavefront OBJ file");
  Checker checker(path);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    checker.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  checker.finish();
}

}  // namespace lanescope
