// SPDX-License-Identifier: MIT
#include "analysis/report/report_checks.h"

#include <algorithm>
#include <cmath>

namespace lanescope {

void require_count(const JsonCursor& cursor, std::uint64_t expected, std::string_view reason) {
  if (cursor.count() != expected) cursor.fail(fmt::format("{}, {}", expected, reason));
}

void require_at_most(const JsonCursor& cursor, std::uint64_t limit, std::string_view reason) {
  if (cursor.count() > limit) cursor.fail(fmt::format("at most {}, {}", limit, reason));
}

void check_ratio(const JsonCursor& cursor, const Ratio& expected) {
  cursor.require_members({"numerator", "denominator", "value"});
  require_count(cursor.member("numerator"), expected.numerator, "which the counts give");
  require_count(cursor.member("denominator"), expected.denominator, "which the counts give");
  const JsonCursor value = cursor.member("value");
  const auto derived = expected.value();
  if (!derived && !value.is_null()) value.fail("null, as the denominator is 0");
  if (derived && std::abs(value.number() - *derived) > 1e-12 * std::abs(*derived))
    value.fail(fmt::format("{}, the numerator over the denominator", *derived));
}

std::string read_figure_name(const JsonCursor& cursor) {
  const std::string name = cursor.string();
  const auto is_letter = [](char c) { return 'a' <= c && c <= 'z'; };
  const auto fits = [&](char c) { return is_letter(c) || ('0' <= c && c <= '9') || c == '_'; };
  if (name.empty() || !is_letter(name.front()) || !std::all_of(name.begin(), name.end(), fits))
    cursor.fail("a name of small letters, digits and underscores that begins with a letter");
  return name;
}

}  // namespace lanescope
