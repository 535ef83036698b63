// SPDX-License-Identifier: MIT
// The sources of the kernels, as they were when the program was built.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lanescope {

struct SourceFile {
  std::string_view path;  ///< From the root of the sources: `kernels/<kind>/<name>.h`.
  std::string_view text;
};

/// Every file in which kernels issue instructions, by path.
const std::vector<SourceFile>& kernel_sources();

/// The text of a line, from 1, without its end; empty if the program does not have it.
std::string_view source_line(std::string_view path, std::uint32_t line);

}  // namespace lanescope
