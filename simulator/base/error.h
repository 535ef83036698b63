// SPDX-License-Identifier: MIT
// The two kinds of failure. InputError is the user's: an option, a file, a mesh; its text begins
// with where. CheckError is ours: an internal invariant or a kernel that breaks the machine's
// rules. Libraries throw; only the command line prints and exits.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lanescope {

/// A mistake in what the user gave. `where` is an option, file:line or file:/json/pointer; the
/// message says what was found and what would be right. The command line exits with status 2.
class InputError : public std::runtime_error {
 public:
  template <class... Args>
  InputError(std::string_view where, fmt::format_string<Args...> format, Args&&... args)
      : std::runtime_error(
            fmt::format("{}: {}", where, fmt::format(format, std::forward<Args>(args)...))) {}
};

/// A broken invariant: `file:line: internal check failed: condition values`.
class CheckError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The candidate nearest to `word` by edit distance, or empty if none is near enough to be what
/// was meant (more than a third of the letters differ).
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `; did you mean 'X'?` for the nearest candidate, or the empty string.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

namespace detail {
[[noreturn]] void fail_check(const char* file, int line, const char* condition,
                             std::string_view values);
}

}  // namespace lanescope

/// Throws CheckError with file, line, the condition and the formatted values when it is false.
/// Never switched off.
#define LANESCOPE_CHECK(condition, ...)                                                           \
  (static_cast<bool>(condition) ? void(0)                                                         \
                                : ::lanescope::detail::fail_check(__FILE__, __LINE__, #condition, \
                                                                  ::fmt::format(__VA_ARGS__)))
