// SPDX-License-Identifier: MIT
// The sources of the repository, as its tests read them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lanescope::test {

std::string read_text(const std::filesystem::path& path);

/// Calls f(path from the root, text) for each C++ file of a folder of the repository, and expects
/// that there is one.
void for_each_source(std::string_view folder,
                     const std::function<void(const std::string&, const std::string&)>& f);

/// The files that a text includes by quotes, as it names them.
std::vector<std::string> includes_of(const std::string& text);

}  // namespace lanescope::test
