// SPDX-License-Identifier: MIT
// Names files that are no text by their first bytes.
#pragma once

#include <string_view>

namespace lanescope {

/// What a file is that cannot be read as text in UTF-8, and what would be right: `is gzip; unpack
/// it with gunzip`. Empty for text.
std::string_view unreadable_kind(std::string_view bytes);

}  // namespace lanescope
