// SPDX-License-Identifier: MIT
#include "analysis/annotation/sources.h"

namespace lanescope {

std::string_view source_line(std::string_view path, std::uint32_t line) {
  for (const SourceFile& file : kernel_sources()) {
    if (file.path != path) continue;
    std::string_view rest = file.text;
    for (std::uint32_t skipped = 1; skipped < line; ++skipped) {
      const std::size_t end = rest.find('\n');
      if (end == rest.npos) return {};
      rest.remove_prefix(end + 1);
    }
    return rest.substr(0, rest.find('\n'));
  }
  return {};
}

}  // namespace lanescope
