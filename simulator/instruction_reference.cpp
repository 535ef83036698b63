// SPDX-License-Identifier: MIT
#include "simulator/instruction_reference.h"

#include <fmt/format.h>

namespace lanescope {
namespace {

constexpr std::string_view kHead = R"(# Instruction reference

Generated from the descriptors in `simulator/instructions/` by `scripts/update-instruction-reference`.

`r`, `s` are result vectors, `m` a result mask, `a`, `b`, `c` operands; `i` runs over the active lanes. Operands are vectors of `float`, `int32` or `uint32`; a scalar in the place of a vector is the vector-scalar form. The mnemonic is also the name of the call: `r = add(on, a, b)`.

Every host gives the same results. Floats follow IEEE 754: each operation rounds by itself, to nearest, ties to even; denormals are kept. Of not-a-number only that it is one is defined, not its sign and payload. Integers wrap. What else a reader might not expect is in the column *at the edges*.

| mnemonic | meaning | at the edges | class | charged |
| --- | --- | --- | --- | --- |
)";

/// The text of a cell of a table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::string instruction_reference(std::span<const InstructionInfo* const> instructions) {
  std::string page(kHead);
  for (const InstructionInfo* info : instructions)
    page +=
        fmt::format("| `{}` | {} | {} | {} | {} |\n", info->mnemonic, cell(info->meaning),
                    cell(info->edges), to_string(info->instruction_class), to_string(info->charge));
  return page;
}

}  // namespace lanescope
