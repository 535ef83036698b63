// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace lanescope {

/// Text that Markdown shows as it is, within a table or anywhere in a line.
std::string markdown_text(std::string_view text);

}  // namespace lanescope
