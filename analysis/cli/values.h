// SPDX-License-Identifier: MIT
// Strict reading of option values: the whole text must be what is asked for, and a complaint names
// the option, what was found and what is allowed.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {

/// An option and the text given for it.
struct Argument {
  std::string_view option;  ///< With its dashes.
  std::string_view text;

  /// Throws InputError: `--option: 'text' is not <expected>`.
  [[noreturn]] void fail(std::string_view expected) const;
};

int parse_integer(const Argument& argument, int low, int high);

/// Threads to use: as asked, or as many as the host has. Warns where the system starts fewer.
int parse_threads(const std::string& text);

/// The elements between commas, of which none is empty or given twice.
std::vector<Argument> parse_list(const Argument& argument);

/// One of the names. `kind` says what they are: `a table`.
std::string parse_name(const Argument& argument, std::string_view kind,
                       const std::vector<std::string>& names);

template <class Value, std::size_t kCount>
Value parse_choice(const Argument& argument, const std::array<Choice<Value>, kCount>& choices) {
  const auto value = find_choice(choices, argument.text);
  if (value) return *value;
  const std::vector<std::string> names = names_of(choices);
  throw InputError(argument.option, "'{}' is not {}{}", argument.text, list_or(names),
                   did_you_mean(argument.text, names));
}

}  // namespace lanescope
