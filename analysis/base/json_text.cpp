// SPDX-License-Identifier: MIT
#include "analysis/base/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineLimit = 140;

bool holds_plain_values(const Json& value) {
  return std::none_of(value.begin(), value.end(),
                      [](const Json& item) { return item.is_structured() && !item.empty(); });
}

/// The value on one line, with a space after each comma and colon.
std::string one_line(const Json& value) {
  if (!value.is_structured()) return value.dump();
  std::string text(1, value.is_object() ? '{' : '[');
  const std::size_t start = text.size();
  for (const auto& [key, item] : value.items()) {
    if (text.size() > start) text += ", ";
    if (value.is_object()) text += Json(key).dump() + ": ";
    text += one_line(item);
  }
  return text + (value.is_object() ? '}' : ']');
}

void append(std::string& text, const Json& value, std::size_t indent) {
  if (!value.is_structured() || value.empty() || holds_plain_values(value)) {
    const std::string line = one_line(value);
    // Lists of numbers stay on one line however long; objects are broken up to be readable.
    if (!value.is_object() || indent + line.size() <= kLineLimit) {
      text += line;
      return;
    }
  }
  const std::string margin(indent + 2, ' ');
  text += value.is_object() ? "{\n" : "[\n";
  bool first = true;
  for (const auto& [key, item] : value.items()) {
    if (!first) text += ",\n";
    first = false;
    text += margin;
    if (value.is_object()) text += Json(key).dump() + ": ";
    append(text, item, indent + 2);
  }
  text += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

double json_number(float value) { return std::strtod(fmt::format("{}", value).c_str(), nullptr); }

double json_ms(double ms) { return std::round(ms * 1000.0) / 1000.0; }

std::string hash_text(std::uint64_t hash) { return fmt::format("{:#018x}", hash); }

std::string json_text(const Json& value) {
  std::string text;
  append(text, value, 0);
  return text + '\n';
}

}  // namespace lanescope
