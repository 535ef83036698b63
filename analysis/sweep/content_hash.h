// SPDX-License-Identifier: MIT
// Hashes that identify texts and files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lanescope {

std::uint64_t text_hash(std::string_view text);

/// The hash of a file's content; none if it cannot be read. A file is read again only if its size
/// or the time of its last change is another, as many cells may be of one file.
std::optional<std::uint64_t> file_hash(const std::string& path);

}  // namespace lanescope
