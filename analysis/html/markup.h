// SPDX-License-Identifier: MIT
// Text that comes from elsewhere, made harmless for the place where it stands on a page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lanescope {

/// For the text of an element or a quoted attribute.
std::string html_escaped(std::string_view text);

/// A document without white space. Bytes of its texts that are not UTF-8 are replaced: a path of a
/// mesh can have any.
std::string json_bytes(const nlohmann::ordered_json& value);

/// A document for a <script> element of JSON: no character of it can end the element.
std::string script_json(const nlohmann::ordered_json& value);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace lanescope
