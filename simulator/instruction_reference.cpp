// SPDX-License-Identifier: MIT
#include "simulator/instruction_reference.h"

#include <fmt/format.h>

#include <algorithm>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

constexpr std::string_view kHead = R"(# Instruction reference

Generated from the structs in `simulator/instructions/` by `scripts/update-instruction-reference`; examples are executed when the page is made.

`r` and `s` are result vectors, `m` is a result mask, `x` a scalar result; `a`, `b`, `c` are operands; `i` runs over the active lanes. Operands are vectors of `float`, `int32` or `uint32`; a scalar in the place of a vector is the vector-scalar form. The mnemonic is also the name of the call: `r = add(on, a, b)`.

Every host gives the same results. Floats follow IEEE 754: each operation rounds by itself, to nearest, ties to even; denormals are kept. Of not-a-number only that it is one is defined, not its sign and payload. Integers wrap. What else a reader might not expect stands *at the edges*.

In examples, `on` are the lanes that are on in the block, and `·` is a lane that holds nothing to rely on. What [checked mode](checked-mode.md) reports beside what it reports of every instruction stands with each.

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

std::string charge_in_words(Charge charge) {
  std::string words(to_string(charge));
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string summary(std::span<const ReferenceEntry> entries) {
  std::string table = "| mnemonic | meaning | class | charged |\n| --- | --- | --- | --- |\n";
  for (const auto& [info, suspicion, keeps_rest, examples] : entries)
    table += fmt::format("| [`{0}`](#{0}) | {1} | {2} | {3} |\n", info.mnemonic, cell(info.meaning),
                         to_string(info.instruction_class), charge_in_words(info.charge));
  return table;
}

/// Rows in columns.
std::string in_columns(const std::vector<ExampleRow>& rows) {
  std::vector<std::size_t> widths{0};
  for (const ExampleRow& row : rows) {
    widths.resize(std::max(widths.size(), row.values.size() + 1));
    widths[0] = std::max(widths[0], row.name.size());
    for (std::size_t i = 0; i < row.values.size(); ++i)
      widths[i + 1] = std::max(widths[i + 1], row.values[i].size());
  }
  std::string text;
  for (const ExampleRow& row : rows) {
    text += fmt::format("{:<{}}", row.name, widths[0]);
    for (std::size_t i = 0; i < row.values.size(); ++i)
      text += fmt::format("  {:>{}}", row.values[i], widths[i + 1]);
    text += '\n';
  }
  return text;
}

std::string section(const ReferenceEntry& entry, const ReferenceNote& note) {
  const InstructionInfo& info = entry.info;
  std::string text = fmt::format("\n### `{}`\n\n`{}`\n\n", info.mnemonic, info.meaning);
  const auto item = [&](std::string_view title, std::string_view words) {
    if (!words.empty()) text += fmt::format("- {}: {}.\n", title, words);
  };
  item("Charged", charge_in_words(info.charge));
  item("At the edges", info.edges);
  if (entry.keeps_rest) item("Lanes that are off", "keep those of further operands, if given");
  if (entry.suspicion) item("Checked mode reports", entry.suspicion->reason);
  if (info.instruction_class == InstructionClass::kReduce)
    item("Checked mode reports", "no lane is active");
  if (note) text += note(info);
  for (const InstructionExample& example : entry.examples)
    text += fmt::format("\n```text\n{}\n\n{}```\n", example.call, in_columns(example.rows));
  return text;
}

std::string title(InstructionClass instruction_class) {
  std::string words(to_string(instruction_class));
  words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

}  // namespace

std::vector<ReferenceEntry> reference_entries() { return reference_entries(InstructionSet{}); }

std::string instruction_reference(std::span<const ReferenceEntry> entries,
                                  const ReferenceNote& note) {
  std::string page(kHead);
  page += summary(entries);
  for (const InstructionClass instruction_class : kInstructionClasses) {
    std::string sections;
    for (const ReferenceEntry& entry : entries)
      if (entry.info.instruction_class == instruction_class) sections += section(entry, note);
    if (!sections.empty()) page += fmt::format("\n## {}\n{}", title(instruction_class), sections);
  }
  return page;
}

}  // namespace lanescope
