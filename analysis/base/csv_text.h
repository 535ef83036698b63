// SPDX-License-Identifier: MIT
// Comma-separated values (RFC 4180), with lines that end in a newline.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lanescope {

/// A field, in quotes if it needs them. What a spreadsheet would take for a formula, as it begins
/// with `=`, `@`, or with a sign and is no number, gets an apostrophe before it.
std::string csv_field(std::string_view text);

/// The fields of one line, each as csv_field has it, and the newline.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace lanescope
