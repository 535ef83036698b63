// SPDX-License-Identifier: MIT
// Reads files as a whole.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lanescope {

/// The bytes of a file. `goes_on`, which may be empty, is called for each block. Throws InputError
/// if the file cannot be read; of a folder it says that `wanted`, as in `a MagicaVoxel file`, would
/// be right.
std::string whole_file(const std::string& path, std::string_view wanted,
                       const std::function<void()>& goes_on = {});

}  // namespace lanescope
