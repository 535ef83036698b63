// SPDX-License-Identifier: MIT
// Finds mistakes in OBJ files, with their lines, before the loader, which knows no positions, reads
// them.
#pragma once

#include <string_view>

namespace lanescope {

/// Checks every statement of the text: keywords, numbers, finite coordinates, faces of at least
/// three corners with indices in range; at least one vertex and one face. Statements that lanescope
/// does not use (groups, materials, texture coordinates) are only checked for their keyword.
/// Throws InputError at `path` or `path:line`.
void check_obj(std::string_view text, std::string_view path);

}  // namespace lanescope
