// SPDX-License-Identifier: MIT
#include "simulator/base/parameter.h"

#include <algorithm>
#include <cmath>

namespace lanescope {

bool Parameter::allows(const Value& value) const {
  if (std::holds_alternative<std::monostate>(value))
    return std::holds_alternative<std::monostate>(fallback);
  switch (kind) {
    case Kind::kSwitch:
      return std::holds_alternative<bool>(value);
    case Kind::kInteger: {
      const auto* integer = std::get_if<std::uint64_t>(&value);
      if (!integer) return false;
      if (!allowed.empty())
        return std::find(allowed.begin(), allowed.end(), *integer) != allowed.end();
      return low <= *integer && *integer <= high;
    }
    case Kind::kNumber: {
      const auto* number = std::get_if<float>(&value);
      return number && std::isfinite(*number) && least <= *number && *number <= most;
    }
    case Kind::kChoice: {
      const auto* word = std::get_if<std::string>(&value);
      return word && std::find(choices.begin(), choices.end(), *word) != choices.end();
    }
    case Kind::kText:
      return std::holds_alternative<std::string>(value);
  }
  return false;
}

std::string Parameter::allowed_values() const {
  std::vector<std::string> names;
  switch (kind) {
    case Kind::kSwitch:
      return "on or off";
    case Kind::kInteger:
      if (allowed.empty())
        return high == std::numeric_limits<std::uint64_t>::max()
                   ? fmt::format("an integer from {} to 2^64 - 1", low)
                   : fmt::format("an integer from {} to {}", low, high);
      for (const std::uint64_t integer : allowed) names.push_back(fmt::format("{}", integer));
      return list_or(names);
    case Kind::kNumber:
      return fmt::format("a number from {} to {}", least, most);
    case Kind::kChoice:
      names.assign(choices.begin(), choices.end());
      return list_or(names);
    case Kind::kText:
      return "a word";
  }
  return {};
}

const Value& Arguments::operator[](std::string_view name) const {
  static const Value kNothing;
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Argument& a) { return a.name == name; });
  return found == all_.end() ? kNothing : found->value;
}

bool Arguments::contains(std::string_view name) const {
  return std::any_of(all_.begin(), all_.end(), [&](const Argument& a) { return a.name == name; });
}

void Arguments::set(std::string_view name, Value value) {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Argument& a) { return a.name == name; });
  if (found == all_.end())
    all_.push_back({std::string(name), std::move(value)});
  else
    found->value = std::move(value);
}

std::string value_text(const Value& value) {
  struct Writer {
    std::string operator()(std::monostate) const { return "none"; }
    std::string operator()(bool on) const { return on ? "on" : "off"; }
    std::string operator()(std::uint64_t integer) const { return fmt::format("{}", integer); }
    std::string operator()(float number) const { return fmt::format("{}", number); }
    std::string operator()(const std::string& word) const { return word; }
  };
  return std::visit(Writer{}, value);
}

}  // namespace lanescope
