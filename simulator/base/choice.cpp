// SPDX-License-Identifier: MIT
#include "simulator/base/choice.h"

namespace lanescope {
namespace {

std::string list(std::span<const std::string> names, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace

std::string list_or(std::span<const std::string> names) { return list(names, " or "); }

std::string list_and(std::span<const std::string> names) { return list(names, " and "); }

}  // namespace lanescope
