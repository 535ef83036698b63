// SPDX-License-Identifier: MIT
#include "analysis/base/markdown_text.h"

namespace lanescope {

std::string markdown_text(std::string_view text) {
  constexpr std::string_view kMarks = "\\|*_`<[";
  std::string escaped;
  for (const char c : text) {
    if (kMarks.find(c) != kMarks.npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace lanescope
