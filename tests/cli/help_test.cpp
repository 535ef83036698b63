// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace lanescope {
namespace {

using testing::lanescope_program;
using testing::Outcome;

/// The commands and, as an empty name, the program itself.
std::vector<std::string> with_program(std::vector<std::string> commands) {
  commands.emplace_back();
  return commands;
}

class Help : public ::testing::TestWithParam<std::string> {};

TEST_P(Help, GoesToStandardOutputWithAnExample) {
  const Outcome help = lanescope_program(GetParam() + " --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.errors, "");
  EXPECT_NE(help.output.find("Usage: lanescope"), std::string::npos);
  EXPECT_NE(help.output.find("Examples:\n  lanescope "), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Commands, Help, ::testing::ValuesIn(with_program(testing::kCommands)),
                         [](const auto& info) {
                           return info.param.empty() ? std::string("program") : info.param;
                         });

TEST(Version, IsOneLine) {
  const Outcome version = lanescope_program("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.output.rfind("lanescope ", 0), 0u);
  EXPECT_EQ(version.output.find('\n'), version.output.size() - 1);
}

class List : public ::testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(List, NamesWhatThereIs) {
  const Outcome list = lanescope_program("list " + GetParam().first);
  EXPECT_EQ(list.status, 0);
  EXPECT_EQ(list.errors, "");
  EXPECT_NE(("\n" + list.output).find("\n" + GetParam().second + " "), std::string::npos)
      << list.output;
}

INSTANTIATE_TEST_SUITE_P(Lists, List,
                         ::testing::Values(std::pair("kernels", "repack"),
                                           std::pair("scenes", "teapot"),
                                           std::pair("instructions", "prefix_sum"),
                                           std::pair("tables", "deviation")),
                         [](const auto& info) { return info.param.first; });

}  // namespace
}  // namespace lanescope
