// SPDX-License-Identifier: MIT
// Comma-separated values (RFC 4180), with lines that end in a newline.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lanescope {

/// A field, in quotes if it needs them.
std::string csv_field(std::string_view text);

/// The fields of one line, each as csv_field has it, and the newline.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace lanescope
