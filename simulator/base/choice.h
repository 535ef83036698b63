// SPDX-License-Identifier: MIT
// Choices: values that have a word for them, on the command line and in reports.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lanescope {

/// A value and the word for it.
template <class T>
struct Choice {
  std::string_view name;
  T value;
};

/// The word for `value`. Requires that it is among the choices.
template <class Choices, class T>
std::string_view name_of(const Choices& choices, const T& value) {
  for (const auto& choice : choices)
    if (choice.value == value) return choice.name;
  return {};
}

/// The value of that name, if there is one.
template <class Choices>
auto find_choice(const Choices& choices, std::string_view name) {
  std::optional<std::remove_cvref_t<decltype(std::begin(choices)->value)>> found;
  for (const auto& choice : choices)
    if (choice.name == name) found = choice.value;
  return found;
}

/// The names of descriptors or of choices, in their order.
template <class Named>
std::vector<std::string> names_of(const Named& all) {
  std::vector<std::string> names;
  for (const auto& one : all) {
    if constexpr (requires { one->name; })
      names.emplace_back(one->name);
    else
      names.emplace_back(one.name);
  }
  return names;
}

/// Names as a sentence lists them: `on or off`, `1, 4 or 9`.
std::string list_or(std::span<const std::string> names);

/// `on and off`, `1, 4 and 9`.
std::string list_and(std::span<const std::string> names);

template <class T>
std::string list_or(std::span<const Choice<T>> choices) {
  return list_or(std::span<const std::string>(names_of(choices)));
}

}  // namespace lanescope
