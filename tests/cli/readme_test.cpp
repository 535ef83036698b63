// SPDX-License-Identifier: MIT
// The commands of the README, as they stand there, on small frames.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "analysis/base/files.h"
#include "tests/cli/program.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

/// What follows `$ build/release/bin/lanescope ` in the README, in order.
std::vector<std::string> commands_of_readme() {
  const std::string text = read_file(fs::path(LANESCOPE_SOURCE_DIR) / "README.md");
  static const std::regex kCommand("\\$ build/release/bin/lanescope ([^\n]+)");
  std::vector<std::string> commands;
  for (std::sregex_iterator it(text.begin(), text.end(), kCommand), end; it != end; ++it)
    commands.push_back((*it)[1]);
  return commands;
}

TEST(Readme, EveryCommandWorks) {
  const testing::ScratchDirectory scratch;
  const fs::path& directory = scratch.path();
  fs::create_directories(directory / "models");
  fs::create_directories(directory / "out");  // As scripts/run, which comes first, leaves it.
  std::ofstream(directory / "models" / "bunny.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  fs::copy(fs::path(LANESCOPE_SOURCE_DIR) / "examples", directory / "examples");
  const auto commands = commands_of_readme();
  EXPECT_GE(commands.size(), 8u);
  for (const std::string& command : commands) {
    const auto outcome = testing::lanescope_program(testing::made_small(command), directory);
    EXPECT_EQ(outcome.status, 0) << command << "\n" << outcome.errors;
  }
}

/// Links to files of the repository lead somewhere.
TEST(Readme, LinksLeadSomewhere) {
  static const std::regex kLink(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  const fs::path root = LANESCOPE_SOURCE_DIR;
  std::vector<fs::path> pages{root / "README.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  EXPECT_GE(pages.size(), 8u);
  for (const fs::path& page : pages) {
    const std::string text = read_file(page);
    for (std::sregex_iterator it(text.begin(), text.end(), kLink), end; it != end; ++it)
      EXPECT_TRUE(fs::exists(page.parent_path() / std::string((*it)[1])))
          << page << " links to " << (*it)[1];
  }
}

}  // namespace
}  // namespace lanescope
