// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "analysis/base/files.h"
#include "analysis/configuration/configuration.h"
#include "tests/cli/program.h"

namespace lanescope {
namespace {

using testing::lanescope_program;
using testing::Outcome;

TEST(Help, GoesToStandardOutputWithAnExample) {
  std::vector<std::string> names = testing::commands_and_studies();
  EXPECT_GE(names.size(), 14u);
  names.emplace_back();  // The program itself.
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const Outcome help = lanescope_program(name + " --help");
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.errors, "");
    EXPECT_NE(help.output.find("Usage: lanescope"), std::string::npos);
    EXPECT_NE(help.output.find("Examples:\n  lanescope "), std::string::npos);
    EXPECT_EQ(help.output.find('{'), std::string::npos) << "a word is not replaced";
  }
}

TEST(Help, ShowsEveryParameterWithItsOptionAndItsDefault) {
  const std::string help = lanescope_program("run --help").output;
  for (const char* words : {"Run:\n", "Kind of work: micropolygons:\n", "Kernels:\n",
                            "--kernel NAME=lockstep,repack", "--width N=8,16,32,64",
                            "--scene NAME=ballroll", "--mode counting|checked|uncounted=counting",
                            "--resolution WIDTHxHEIGHT=1728x1080", "--msaa N=4", "--cull on|off=on",
                            "(lanes / W; a number from 0 to 1)", "an integer from 0 to 2^64 - 1",
                            "as the scene has it if left out", "--width 8,16 or --width 1:64"})
    EXPECT_NE(help.find(words), std::string::npos) << words << "\n" << help;
  for (const std::string& parameter : testing::listed("parameters")) {
    ASSERT_NE(find_parameter(parameter), nullptr) << parameter;
    const std::string option(find_parameter(parameter)->words.option);
    EXPECT_NE(help.find("  " + option + " "), std::string::npos) << parameter;
  }
}

TEST(Help, ShowsWhatACommandHasByDefault) {
  const auto expect_in = [](const std::string& command, std::initializer_list<const char*> all) {
    const std::string help = lanescope_program(command + " --help").output;
    for (const char* words : all) EXPECT_NE(help.find(words), std::string::npos) << help;
  };
  expect_in("render",
            {"--kernel NAME=lockstep ", "--width N=8 ", "=uncounted", "--show WHAT=output"});
  expect_in("annotate", {"--kernel NAME=repack ", "--width N=16 "});
  expect_in("trace", {"--kernel NAME=lockstep,repack\n", "--width N=16 "});
  for (const char* study : {"study luong", "tables"})
    expect_in(study, {"--kernel NAME=lockstep,repack", "--scene NAME=all", "triangle,quad"});
}

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

INSTANTIATE_TEST_SUITE_P(
    Lists, List,
    ::testing::Values(std::pair("kernels", "repack"), std::pair("workloads", "micropolygons"),
                      std::pair("scenes", "teapot"), std::pair("instructions", "prefix_sum"),
                      std::pair("parameters", "stream_load_threshold"), std::pair("tables", "mix"),
                      std::pair("studies", "luong"), std::pair("commands", "sweep")),
    [](const auto& info) { return info.param.first; });

/// What is not part of a registry of its own is listed beside it.
TEST(Lists, NameWhatKernelsAndStudiesHave) {
  const auto expect_line = [](const std::string& what, const std::string& words) {
    const std::string list = lanescope_program("list " + what).output;
    EXPECT_NE(list.find(words), std::string::npos) << list;
  };
  expect_line("kernels", "takes micropolygons; W = 1 to 64\n");
  expect_line("kernels", "takes micropolygons; W = 1\n");
  expect_line("instructions", "\nframe_merge ");
  expect_line("tables", "; of the study luong\n");
  expect_line("scenes", "; one of `thesis`\n");
  expect_line("scenes", "\nFILE.obj ");
}

TEST(Lists, HaveTheReferenceOfInstructions) {
  EXPECT_EQ(lanescope_program("list instructions --reference").output,
            read_file(LANESCOPE_SOURCE_DIR "/docs/instructions.md"));
}

TEST(Lists, SayOptionDefaultValuesAndTakersOfParameters) {
  const std::string list = lanescope_program("list parameters").output;
  for (const char* words :
       {"\nwidth_px               --resolution             1728                 "
        "an integer from 1 to 16384 (px)                rastmp, lockstep and repack\n",
        " --stream-load-threshold  0                    "
        "a number from 0 to 1 (lanes / W)               repack\n",
        "\nframe                  --frame                  as the scene has it  "})
    EXPECT_NE(list.find(words), std::string::npos) << words << "\n" << list;
}

}  // namespace
}  // namespace lanescope
