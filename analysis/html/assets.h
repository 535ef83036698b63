// SPDX-License-Identifier: MIT
// The files that the page is made of, built into the program.
#pragma once

#include <string_view>

namespace lanescope {

/// The page with its places, its style and its program: page.html, page.css, page.js.
std::string_view page_template();
std::string_view page_style();
std::string_view page_program();

/// docs/page.md.
std::string_view page_guide();

/// The libraries that draw charts, in the order in which a page loads them.
std::string_view vega();
std::string_view vega_lite();
std::string_view vega_embed();
/// The licences of these libraries and of what they contain.
std::string_view library_licences();

}  // namespace lanescope
