// SPDX-License-Identifier: MIT
#include "analysis/html/guide.h"

#include <fmt/format.h>
#include <md4c-html.h>

#include "analysis/html/assets.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// The text below a heading of the third level, up to the next heading.
std::string_view text_below(std::string_view title) {
  const std::string_view guide = page_guide();
  const std::string heading = fmt::format("\n### {}\n", title);
  const std::size_t at = guide.find(heading);
  if (at == guide.npos) return {};
  const std::string_view rest = guide.substr(at + heading.size());
  return rest.substr(0, rest.find("\n#"));
}

void append(const char* text, MD_SIZE size, void* html) {
  static_cast<std::string*>(html)->append(text, size);
}

}  // namespace

std::string guide_html(std::string_view title) {
  const std::string_view text = text_below(title);
  std::string html;
  const int status = md_html(text.data(), static_cast<MD_SIZE>(text.size()), append, &html,
                             MD_DIALECT_COMMONMARK, 0);
  LANESCOPE_CHECK(status == 0, "md4c returned {}", status);
  return html;
}

}  // namespace lanescope
