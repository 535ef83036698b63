// SPDX-License-Identifier: MIT
// Data within the page, small: a page of a sweep has as many figures as cells.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lanescope {

/// The bytes compressed (zlib, RFC 1950), in base64; what `unpacked` of page.js reads.
std::string packed(std::string_view bytes);

/// A <script> element that holds the document, packed; page.js finds it by its class `packed`.
std::string packed_script(const nlohmann::ordered_json& value);

}  // namespace lanescope
