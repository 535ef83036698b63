// SPDX-License-Identifier: MIT
// What there is to choose from, as lines of text.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lanescope {

struct List {
  std::string_view name;
  std::string (*text)();
};

/// Every list, in the order of the help.
std::span<const List> lists();

inline constexpr std::string_view kInstructionList = "instructions";

/// The reference of the instruction set (docs/instructions.md).
std::string reference_of_instructions();

/// The instruction set, the program's own instructions, then what kernels issue beside them:
/// mnemonic, class, charge, meaning.
std::string list_instructions();

/// Names and summaries.
std::string list_studies();

}  // namespace lanescope
