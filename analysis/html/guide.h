// SPDX-License-Identifier: MIT
// How to read the sections of the page, from docs/page.md, which is built into the program.
#pragma once

#include <string>
#include <string_view>

namespace lanescope {

/// What stands below the heading `### <title>` of docs/page.md, as HTML; empty without such a
/// heading.
std::string guide_html(std::string_view title);

}  // namespace lanescope
