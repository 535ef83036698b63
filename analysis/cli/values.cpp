// SPDX-License-Identifier: MIT
#include "analysis/cli/values.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace lanescope {
namespace {

/// Reads the whole text as a number; false if that is not what it is.
template <class Number>
bool read_whole(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace

void Argument::fail(std::string_view expected) const {
  throw InputError(option, "'{}' is not {}", text, expected);
}

int parse_integer(const Argument& argument, int low, int high) {
  int number = 0;
  if (!read_whole(argument.text, number) || number < low || number > high)
    argument.fail(fmt::format("an integer from {} to {}", low, high));
  return number;
}

std::uint64_t parse_seed(const Argument& argument) {
  std::uint64_t number = 0;
  if (!read_whole(argument.text, number)) argument.fail("an integer from 0 to 2^64 - 1");
  return number;
}

float parse_number(const Argument& argument, float low, float high) {
  float number = 0.0f;
  const bool read = read_whole(argument.text, number) && std::isfinite(number);
  if (!read || number < low || number > high)
    argument.fail(fmt::format("a number from {} to {}", low, high));
  return number;
}

std::vector<Argument> parse_list(const Argument& argument) {
  std::vector<Argument> elements;
  std::string_view rest = argument.text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const Argument element{argument.option, rest.substr(0, comma)};
    more = comma != rest.npos;
    if (more) rest.remove_prefix(comma + 1);
    if (element.text.empty())
      throw InputError(argument.option,
                       "'{}' has an empty element; separate values by single commas",
                       argument.text);
    if (std::any_of(elements.begin(), elements.end(),
                    [&](const Argument& other) { return other.text == element.text; }))
      throw InputError(argument.option, "'{}' has '{}' twice", argument.text, element.text);
    elements.push_back(element);
  }
  return elements;
}

std::string parse_name(const Argument& argument, std::string_view kind,
                       const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), argument.text) != names.end())
    return std::string(argument.text);
  const bool are_words = !names.empty() && std::isalpha(static_cast<unsigned char>(names[0][0]));
  throw InputError(argument.option, "'{}' is not {}; use {}{}", argument.text, kind, list_or(names),
                   are_words ? did_you_mean(argument.text, names) : "");
}

}  // namespace lanescope
