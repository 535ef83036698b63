// SPDX-License-Identifier: MIT
// The descriptions of machines that the program comes with, as texts.
#pragma once

#include <vector>

namespace lanescope {

struct ShippedText {
  const char* file;
  const char* text;
};

/// A machine stands behind the one that it inherits from. Generated from
/// analysis/machines/CMakeLists.txt.
const std::vector<ShippedText>& shipped_texts();

}  // namespace lanescope
