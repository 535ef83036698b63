// SPDX-License-Identifier: MIT
// What the readers of reports check beside the types of values: counts against other counts, and
// names against names.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/base/json_cursor.h"
#include "analysis/report/figures.h"
#include "analysis/report/report.h"

namespace lanescope {

/// Checks a count that other counts give.
void require_count(const JsonCursor& cursor, std::uint64_t expected, std::string_view reason);

/// Checks a count of some among `limit`.
void require_at_most(const JsonCursor& cursor, std::uint64_t limit, std::string_view reason);

/// Checks that a ratio is what the counts give, so that an edited report is not believed.
void check_ratio(const JsonCursor& cursor, const Ratio& expected);

/// A name of a figure: small letters, digits and underscores.
std::string read_figure_name(const JsonCursor& cursor);

/// Reads the elements of a list, in which the member `key` names each: no two have the same.
template <class Read>
auto read_named(const JsonCursor& list, std::string_view key, Read&& read) {
  std::vector<decltype(read(list))> records;
  std::set<std::string> names;
  for (const JsonCursor& item : list.items()) {
    records.push_back(read(item));
    const JsonCursor name = item.member(key);
    if (!names.insert(name.string()).second)
      throw InputError(name.where(), "\"{}\" is that of an earlier element, too; each has its own",
                       name.string());
  }
  return records;
}

}  // namespace lanescope
