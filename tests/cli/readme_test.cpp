// SPDX-License-Identifier: MIT
// The commands of the README, as they stand there, on small frames.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

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
  // They write into folders that git ignores.
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  EXPECT_EQ(names, (std::set<std::string>{"examples", "models", "out"}));
}

/// The files that lines with a command of the program write, as they stand on a page.
std::vector<std::string> results_on(const fs::path& page) {
  static const std::regex kResult(
      " (-o|--json|--out|--png|--svg|--chrome|--listing) ([a-z0-9][^ `]*)");
  std::vector<std::string> results;
  std::ifstream in(page);
  for (std::string line; std::getline(in, line);) {
    if (line.find("lanescope ") == line.npos) continue;
    for (std::sregex_iterator it(line.begin(), line.end(), kResult), end; it != end; ++it)
      results.push_back((*it)[2]);
  }
  return results;
}

/// No page asks for a result beside the sources.
TEST(Readme, EveryResultOfADocumentedCommandGoesToOut) {
  const fs::path root = LANESCOPE_SOURCE_DIR;
  std::vector<fs::path> pages{root / "README.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  std::size_t count = 0;
  for (const fs::path& page : pages)
    for (const std::string& result : results_on(page)) {
      EXPECT_TRUE(result == "out" || result.starts_with("out/")) << page << ": " << result;
      ++count;
    }
  EXPECT_GE(count, 20u);
}

/// What the README runs is there after the command that it begins with.
TEST(Readme, EveryProgramIsBuiltByTheScriptThatComesFirst) {
  const fs::path root = LANESCOPE_SOURCE_DIR;
  const std::string readme = read_file(root / "README.md");
  const std::string script = read_file(root / "scripts" / "run");
  std::smatch targets;
  static const std::regex kTargets("cmake --build --preset release --target ([a-z_ ]+)");
  ASSERT_TRUE(std::regex_search(script, targets, kTargets));
  static const std::regex kProgram("\\$ build/release/bin/([a-z_]+)");
  std::set<std::string> programs;
  for (std::sregex_iterator it(readme.begin(), readme.end(), kProgram), end; it != end; ++it)
    programs.insert((*it)[1]);
  EXPECT_GE(programs.size(), 2u);
  for (const std::string& program : programs)
    EXPECT_NE((" " + targets[1].str() + " ").find(" " + program + " "), std::string::npos)
        << program;
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
    // Code may look like a link.
    static const std::regex kCode("```[^]*?\n```");
    const std::string text = std::regex_replace(read_file(page), kCode, "");
    for (std::sregex_iterator it(text.begin(), text.end(), kLink), end; it != end; ++it)
      EXPECT_TRUE(fs::exists(page.parent_path() / std::string((*it)[1])))
          << page << " links to " << (*it)[1];
  }
}

}  // namespace
}  // namespace lanescope
