// SPDX-License-Identifier: MIT
// The reference shows every instruction of the set, with an example that was executed.
#include "simulator/instruction_reference.h"

#include <gtest/gtest.h>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

/// An instruction from outside the set.
struct Halve {
  static constexpr InstructionInfo kInfo{"halve", "r[i] = a[i] / 2", InstructionClass::kArithmetic,
                                         Charge::kAllLanes, "odd int32 truncate"};
  static float lane(float a) { return a / 2; }
  static std::int32_t lane(std::int32_t a) { return a / 2; }
  static constexpr Suspicion kSuspicion{Check::kOperand, "the value is odd"};
  static bool suspicious(std::int32_t a) { return a % 2 != 0; }
};

const std::vector<std::string>& row(const InstructionExample& example, std::string_view name) {
  for (const ExampleRow& row : example.rows)
    if (row.name == name) return row.values;
  throw std::out_of_range(fmt::format("no row {}", name));
}

TEST(InstructionReference, HasAnExampleAndAnEquationOfEveryInstruction) {
  const auto entries = reference_entries();
  EXPECT_EQ(entries.size(), InstructionSet::kSize);
  for (const ReferenceEntry& entry : entries) {
    SCOPED_TRACE(entry.info.mnemonic);
    EXPECT_FALSE(entry.examples.empty());
    EXPECT_NE(entry.info.meaning.find("= "), std::string_view::npos);
  }
}

TEST(InstructionReference, ExamplesAreExecuted) {
  const auto examples = examples_of<Halve>();
  ASSERT_EQ(examples.size(), 2u);
  const InstructionExample& ints = examples[1];
  EXPECT_EQ(ints.call, "r = halve(on, a)");
  const auto &on = row(ints, "on"), &a = row(ints, "a"), &r = row(ints, "r");
  ASSERT_EQ(r.size(), 8u);
  for (std::size_t i = 0; i < r.size(); ++i)
    EXPECT_EQ(r[i], on[i] == "1" ? std::to_string(std::stoi(a[i]) / 2) : "·") << "lane " << i;
}

TEST(InstructionReference, ShowsWhatTheStructSays) {
  const std::vector<ReferenceEntry> entries{reference_entry<Halve>()};
  const std::string page = instruction_reference(entries, [](const InstructionInfo& info) {
    return fmt::format("- Costs of {}: none.\n", info.mnemonic);
  });
  for (const char* words :
       {"\n| [`halve`](#halve) | r[i] = a[i] / 2 | arithmetic | all lanes |\n",
        "\n### `halve`\n\n`r[i] = a[i] / 2`\n\n- Charged: all lanes.\n"
        "- At the edges: odd int32 truncate.\n- Checked mode reports: the value is odd.\n"
        "- Costs of halve: none.\n\n```text\nr = halve(on, a)\n"})
    EXPECT_NE(page.find(words), std::string::npos) << words << page;
}

TEST(InstructionReference, WhatAUserCallsSuspiciousIsReported) {
  SlowMachine<8> vm(8, 1, Mode::kChecked);
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  constexpr Instruction<Halve> halve;
  const auto lanes = isa::lane_index(on);
  EXPECT_THROW(halve(on, lanes), FailedCheck);
  EXPECT_NO_THROW(halve(on.allowing(Check::kOperand), lanes));
  EXPECT_NO_THROW(halve(on, isa::mul(on, lanes, 2)));
}

}  // namespace
}  // namespace lanescope
