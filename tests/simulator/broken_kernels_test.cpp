// SPDX-License-Identifier: MIT
// Each of a catalogue of broken kernels is found by one check, and by no other one; the catalogue
// in docs/checked-mode.md is this one.
#include "tests/simulator/broken_kernels.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <vector>

#include "analysis/experiment/width_independence.h"
#include "tests/repository/source_files.h"

namespace lanescope::test {
namespace {

constexpr std::string_view kFile = "tests/simulator/broken_kernels.cpp";
constexpr std::string_view kWrong = "  // wrong";

std::string read_source(std::string_view path) {
  return read_text(std::filesystem::path(LANESCOPE_SOURCE_DIR) / path);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The line of a kernel's source that is at fault.
struct Fault {
  int line;  ///< From 1.
  std::string code;
};

Fault fault_of(std::string_view kernel) {
  const auto lines = lines_of(read_source(kFile));
  const std::string head = fmt::format("void {}(Vm& vm) {{", kernel);
  auto line = std::find(lines.begin(), lines.end(), head);
  while (line != lines.end() && !line->ends_with(kWrong)) ++line;
  if (line == lines.end()) {
    ADD_FAILURE() << kernel << " has no line that is wrong";
    return {};
  }
  const auto code = line->substr(line->find_first_not_of(' '));
  return {static_cast<int>(line - lines.begin()) + 1, code.substr(0, code.size() - kWrong.size())};
}

/// Expects that none of the checks but `left_out` finds anything.
void expect_nothing_else(const BrokenKernel& kernel) {
  SlowMachine<8> vm(kernel.width, 1, Mode::kChecked);
  vm.leave_out(kernel.check);
  EXPECT_NO_THROW(kernel.run(vm));
}

class EachBrokenKernel : public testing::TestWithParam<BrokenKernel> {};

TEST_P(EachBrokenKernel, IsFoundByOneCheck) {
  const BrokenKernel& kernel = GetParam();
  SlowMachine<8> vm(kernel.width, 1, Mode::kChecked);
  try {
    kernel.run(vm);
    ADD_FAILURE() << "nothing was found";
  } catch (const FailedCheck& e) {
    EXPECT_EQ(e.what(),
              fmt::format("{}:{}: {}", kFile, fault_of(kernel.name).line, kernel.message));
    EXPECT_EQ(to_string(e.check()), to_string(kernel.check));
  }
  expect_nothing_else(kernel);
}

INSTANTIATE_TEST_SUITE_P(, EachBrokenKernel, testing::ValuesIn(broken_kernels()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(BrokenKernels, TryEveryCheckOfTheInstructionSet) {
  std::set<std::string_view> tried;
  for (const BrokenKernel& kernel : broken_kernels()) tried.insert(to_string(kernel.check));
  for (Check check = Check::kDeadLane; check <= Check::kNoLane;
       check = static_cast<Check>(static_cast<int>(check) + 1))
    EXPECT_TRUE(tried.contains(to_string(check))) << to_string(check);
}

/// What has a defined result may be meant, and the rest of the instruction is still checked.
TEST(CheckedMode, AllowsWhatIsMeant) {
  SlowMachine<8> vm(8, 1, Mode::kChecked);
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto lanes = isa::lane_index(on);
  const auto counts = isa::add(on, lanes, 28);
  EXPECT_THROW(isa::shl(on, 1, counts), FailedCheck);
  EXPECT_EQ(isa::shl(on.allowing(Check::kShiftCount), 1, counts).vec[4], 1);
  EXPECT_THROW(isa::shl(on.allowing(Check::kNan), 1, counts), FailedCheck);
  EXPECT_NO_THROW(isa::shl(on.overhead().allowing(Check::kShiftCount), 1, counts));
  for (const Check check :
       {Check::kDeadLane, Check::kBeyondWidth, Check::kBounds, Check::kUnwritten})
    EXPECT_THROW(on.allowing(check), CheckError) << to_string(check);
  EXPECT_EQ(vm.counts().stages[0].total().overhead_issued, 1u);
}

/// What a program gives at each width from 1 to 8.
std::vector<std::int32_t> results_by_width(std::int32_t (*run)(SlowMachine<8>& vm)) {
  std::vector<std::int32_t> results;
  for (int width = 1; width <= 8; ++width) {
    SlowMachine<8> vm(width, 1, Mode::kChecked);
    results.push_back(run(vm));
  }
  return results;
}

/// What is found when runs of these results are compared; empty if nothing.
std::string width_failure(const std::vector<std::int32_t>& results) {
  std::vector<RunRecord> runs(results.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].configuration.kernel = width_dependence().name;
    runs[i].configuration.scene = "heights";
    runs[i].configuration.mode = Mode::kChecked;
    runs[i].configuration.width = static_cast<int>(i) + 1;
    runs[i].results_hash = static_cast<std::uint64_t>(results[i]);
  }
  try {
    require_width_independence(runs);
  } catch (const FailedCheck& e) {
    EXPECT_EQ(to_string(e.check()), to_string(Check::kWidth));
    return e.what();
  }
  return {};
}

TEST(BrokenKernels, ResultsThatDependOnTheWidthAreFoundByComparingRuns) {
  EXPECT_EQ(width_failure(results_by_width(width_dependence().run)), width_dependence().message);
  EXPECT_EQ(width_failure(results_by_width(width_dependence().repaired)), "");
}

/// The catalogue as it stands in the document.
std::string catalogue() {
  std::string table =
      "| kernel | what is wrong | where | what checked mode says | check |\n"
      "| --- | --- | --- | --- | --- |\n";
  for (const BrokenKernel& kernel : broken_kernels())
    table += fmt::format("| `{}` | {} | `{}` | {} | `{}` |\n", kernel.name, kernel.mistake,
                         fault_of(kernel.name).code, kernel.message, to_string(kernel.check));
  table += fmt::format("| `{}` | {} | {} at W = 1 to 8 | {} | `{}` |\n", width_dependence().name,
                       width_dependence().mistake,
                       fmt::join(results_by_width(width_dependence().run), ", "),
                       width_dependence().message, to_string(Check::kWidth));
  return table;
}

TEST(Documents, TheCatalogueOfBrokenKernelsIsCurrent) {
  const std::string page = read_source("docs/checked-mode.md");
  EXPECT_NE(page.find(catalogue()), std::string::npos) << "docs/checked-mode.md should have:\n"
                                                       << catalogue();
  for (Check check = Check::kDeadLane; check <= Check::kOperand;
       check = static_cast<Check>(static_cast<int>(check) + 1))
    EXPECT_NE(page.find(fmt::format("\n| `{}` | ", to_string(check))), std::string::npos)
        << to_string(check);
}

}  // namespace
}  // namespace lanescope::test
