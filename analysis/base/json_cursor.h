// SPDX-License-Identifier: MIT
// A value in a JSON document together with where it is, so that every complaint about it can begin
// with `file.json:/json/pointer`, say what was found and what would be right.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/error.h"

namespace lanescope {

/// Parses a document. Throws InputError, beginning with `file:line:column`, if the text is not JSON
/// or an object has a key twice.
nlohmann::ordered_json parse_json(std::string_view text, const std::string& file);

/// Points at a value of a document, which must outlive it.
class JsonCursor {
 public:
  using Json = nlohmann::ordered_json;

  JsonCursor(const Json& value, std::string file, std::string pointer = "")
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  /// Checks that the value is an object with exactly these members.
  void require_members(const std::vector<std::string>& names) const;
  /// Checks that the value is an object with no other members than these.
  void allow_members(const std::vector<std::string>& names) const;
  bool has_member(std::string_view name) const;
  JsonCursor member(std::string_view name) const;
  /// The names of the members in their order. Throws InputError if the value is not an object.
  std::vector<std::string> member_names() const;
  const Json& value() const { return *value_; }
  bool is_array() const { return value_->is_array(); }
  /// The elements. Throws InputError if the value is not an array.
  std::vector<JsonCursor> items() const;

  std::string string() const;
  bool boolean() const;
  bool is_null() const { return value_->is_null(); }
  /// A count: an integer in [0, 2^64).
  std::uint64_t count() const;
  int integer(int low, int high = std::numeric_limits<int>::max()) const;
  double number() const;
  double number_from_0() const;
  /// 64 bits as `0x` and 16 hexadecimal digits, in small letters.
  std::uint64_t hash() const;

  /// `file:/json/pointer`.
  std::string where() const;
  /// Throws InputError: `where: found is not expected`.
  [[noreturn]] void fail(std::string_view expected) const;

 private:
  void require_member(const std::string& name) const;
  const Json* value_;
  std::string file_;
  std::string pointer_;
};

/// Reads each element of an array.
template <class Value>
std::vector<Value> read_list(const JsonCursor& list, Value (*read)(const JsonCursor&)) {
  std::vector<Value> values;
  for (const JsonCursor& item : list.items()) values.push_back(read(item));
  return values;
}

}  // namespace lanescope
