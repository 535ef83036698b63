// SPDX-License-Identifier: MIT
#include "analysis/base/json_cursor.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kFoundLimit = 60;

/// `line:column` of the byte that ends the text read so far, both from 1.
std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("{}:{}", lines + 1, before.size() - line_start + 1);
}

/// The reason within nlohmann's message, which follows its position.
std::string reason(std::string_view message) {
  const std::size_t mark = message.find("syntax error");
  return std::string(mark == message.npos ? message : message.substr(mark));
}

/// The number within nlohmann's message that it overflows.
std::string overflowing_number(std::string_view message) {
  const std::size_t first = message.find('\'') + 1;
  return std::string(message.substr(first, message.rfind('\'') - first));
}

/// The byte, from 1, at which a number begins in the text outside of strings.
std::size_t byte_of(std::string_view text, std::string_view number) {
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!in_string && text.substr(i).starts_with(number)) return i + 1;
    if (in_string && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      in_string = !in_string;
  }
  return 1;
}

/// Finds keys that an object has twice, of which the parser would silently keep one.
class DuplicateKeys {
 public:
  bool operator()(Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open_.emplace_back();
    if (event == Json::parse_event_t::object_end) open_.pop_back();
    if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second)
      found = parsed.get<std::string>();
    return true;
  }
  std::optional<std::string> found;

 private:
  std::vector<std::set<std::string>> open_;
};

std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
  DuplicateKeys duplicates;
  try {
    Json parsed = Json::parse(text, [&](int, Json::parse_event_t event, Json& value) {
      return duplicates(event, value);
    });
    if (duplicates.found)
      throw InputError(file, "an object has the member '{}' twice", *duplicates.found);
    return parsed;
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("{}:{}", file, line_and_column(text, error.byte)),
                     "is not JSON: {}", reason(error.what()));
  } catch (const Json::out_of_range& error) {
    const std::string number = overflowing_number(error.what());
    throw InputError(fmt::format("{}:{}", file, line_and_column(text, byte_of(text, number))),
                     "{} is not a number up to 1.8e308", number);
  }
}

void JsonCursor::require_members(const std::vector<std::string>& names) const {
  allow_members(names);
  for (const std::string& name : names) require_member(name);
}

void JsonCursor::allow_members(const std::vector<std::string>& names) const {
  for (const std::string& key : member_names())
    if (std::find(names.begin(), names.end(), key) == names.end())
      throw InputError(where(), "unknown member '{}'{}", key, did_you_mean(key, names));
}

bool JsonCursor::has_member(std::string_view name) const {
  return value_->is_object() && value_->contains(std::string(name));
}

std::vector<std::string> JsonCursor::member_names() const {
  if (!value_->is_object()) fail("an object");
  std::vector<std::string> names;
  for (const auto& [key, item] : value_->items()) names.push_back(key);
  return names;
}

void JsonCursor::require_member(const std::string& name) const {
  if (!value_->is_object()) fail("an object");
  if (!value_->contains(name)) throw InputError(where(), "the member '{}' is missing", name);
}

JsonCursor JsonCursor::member(std::string_view name) const {
  require_member(std::string(name));
  return {value_->at(std::string(name)), file_, fmt::format("{}/{}", pointer_, escaped(name))};
}

std::vector<JsonCursor> JsonCursor::items() const {
  if (!value_->is_array()) fail("an array");
  std::vector<JsonCursor> cursors;
  for (std::size_t i = 0; i < value_->size(); ++i)
    cursors.emplace_back((*value_)[i], file_, fmt::format("{}/{}", pointer_, i));
  return cursors;
}

std::string JsonCursor::string() const {
  if (!value_->is_string()) fail("a string");
  return value_->get<std::string>();
}

bool JsonCursor::boolean() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

std::uint64_t JsonCursor::count() const {
  if (!value_->is_number_unsigned()) fail("an integer from 0 to 2^64 - 1");
  return value_->get<std::uint64_t>();
}

int JsonCursor::integer(int low, int high) const {
  const bool whole = value_->is_number_integer();
  const bool fits = whole && (!value_->is_number_unsigned() ||
                              value_->get<std::uint64_t>() <= std::uint64_t{1} << 62);
  const std::int64_t found = fits ? value_->get<std::int64_t>() : 0;
  if (!fits || found < low || found > high)
    fail(high == std::numeric_limits<int>::max()
             ? fmt::format("an integer of at least {}", low)
             : fmt::format("an integer from {} to {}", low, high));
  return static_cast<int>(found);
}

double JsonCursor::number() const {
  if (!value_->is_number()) fail("a number");
  return value_->get<double>();
}

double JsonCursor::number_from_0() const {
  if (!value_->is_number() || value_->get<double>() < 0.0) fail("a number of at least 0");
  return value_->get<double>();
}

std::uint64_t JsonCursor::hash() const {
  const std::string text = value_->is_string() ? value_->get<std::string>() : std::string();
  std::uint64_t hash = 0;
  const char* const end = text.data() + text.size();
  if (text.size() != 18 || text.compare(0, 2, "0x") != 0 ||
      std::from_chars(text.data() + 2, end, hash, 16).ptr != end ||
      text.find_first_of("ABCDEF") != text.npos)
    fail("a string of 0x and 16 hexadecimal digits, in small letters");
  return hash;
}

std::string JsonCursor::where() const {
  return fmt::format("{}:{}", file_, pointer_.empty() ? "/" : pointer_);
}

void JsonCursor::fail(std::string_view expected) const {
  std::string found = value_->is_object()  ? "an object"
                      : value_->is_array() ? "an array"
                                           : value_->dump();
  if (found.size() > kFoundLimit) found = found.substr(0, kFoundLimit) + "...";
  throw InputError(where(), "{} is not {}", found, expected);
}

}  // namespace lanescope
