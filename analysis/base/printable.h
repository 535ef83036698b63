// SPDX-License-Identifier: MIT
// Text that came from outside, such as the name of a file, as it can be shown.
#pragma once

#include <string>
#include <string_view>

namespace lanescope {

/// Whether the text is UTF-8 without control characters, as JSON and terminals take it as it is.
bool is_printable(std::string_view text);

/// The text on one line, with control characters and bytes that are not UTF-8 as `\n`, `\t`, `\r`
/// or `\x1b`; what is printable stays as it is.
std::string printable(std::string_view text);

}  // namespace lanescope
