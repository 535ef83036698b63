// SPDX-License-Identifier: MIT
// What holds of the repository itself: the direction of includes, who may print or exit, how long
// files are, and that generated documents are current.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "simulator/base/error.h"
#include "simulator/instruction_reference.h"
#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = LANESCOPE_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Calls f(path relative to the root, text) for each C++ file of a folder.
template <class F>
void for_each_source(const char* folder, F&& f) {
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp" && extension != ".in") continue;
    ++seen;
    f(fs::relative(entry.path(), kRoot).generic_string(), read(entry.path()));
  }
  EXPECT_GT(seen, 0u) << folder;
}

std::vector<std::string> includes_of(const std::string& text) {
  static const std::regex kInclude("#include \"([^\"]+)\"");
  std::vector<std::string> includes;
  for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it)
    includes.push_back((*it)[1]);
  return includes;
}

bool starts_with_any(const std::string& path, const std::vector<std::string>& prefixes) {
  for (const auto& prefix : prefixes)
    if (path.starts_with(prefix)) return true;
  return false;
}

TEST(Layering, IncludesRunOneWay) {
  const std::map<const char*, std::vector<std::string>> allowed = {
      {"simulator", {"simulator/"}},
      {"workloads", {"workloads/", "simulator/base/"}},
      {"kernels",
       {"kernels/", "simulator/", "workloads/micropolygons/micropolygon.h", "workloads/micropolygons/sample_grid.h"}},
      {"analysis", {"analysis/", "kernels/", "workloads/", "simulator/"}},
  };
  for (const auto& [folder, prefixes] : allowed) {
    for_each_source(folder, [&](const std::string& path, const std::string& text) {
      for (const std::string& include : includes_of(text)) {
        if (include.find('/') == std::string::npos) continue;  // generated, beside the file
        EXPECT_TRUE(starts_with_any(include, prefixes)) << path << " includes " << include;
      }
    });
  }
}

TEST(Layering, IncludesWithinAnalysisRunOneWay) {
  // Each folder may include itself and those before it.
  const std::vector<std::string> order = {
      "base",  "configuration", "report",     "tables",     "formats", "pictures", "experiment",
      "sweep", "trace",         "annotation", "comparison", "html",    "cli"};
  for_each_source("analysis", [&](const std::string& path, const std::string& text) {
    const auto folder_of = [](const std::string& name) {
      const std::size_t begin = std::string("analysis/").size();
      return name.substr(begin, name.find('/', begin) - begin);
    };
    const auto rank = [&](const std::string& folder) {
      return std::find(order.begin(), order.end(), folder) - order.begin();
    };
    const auto own = rank(folder_of(path));
    EXPECT_LT(own, static_cast<std::ptrdiff_t>(order.size())) << path << " is in no known folder";
    for (const std::string& include : includes_of(text))
      if (include.starts_with("analysis/") && include.find('/', 9) != std::string::npos)
        EXPECT_LE(rank(folder_of(include)), own) << path << " includes " << include;
  });
}

TEST(Layering, OnlyTheCommandLinePrintsOrExits) {
  static const std::regex kPrints(
      R"(std::cout|std::cerr|std::exit|[^a-z_]exit\(|fmt::print\(|[^a-z_:]printf\(|std::puts)");
  for (const char* folder : {"simulator", "workloads", "kernels", "analysis"}) {
    for_each_source(folder, [&](const std::string& path, const std::string& text) {
      if (path.starts_with("analysis/cli/")) return;
      EXPECT_FALSE(std::regex_search(text, kPrints)) << path;
    });
  }
}

TEST(Sources, AreOfReadableLength) {
  for (const char* folder : {"simulator", "workloads", "kernels", "analysis"}) {
    for_each_source(folder, [](const std::string& path, const std::string& text) {
      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 500) << path;
      EXPECT_NE(text.find("SPDX-License-Identifier: MIT"), std::string::npos)
          << path << " names no licence";
    });
  }
}

/// docs/instructions.md is made from the descriptors, and nothing else is in it.
TEST(Documents, TheInstructionReferenceIsCurrent) {
  EXPECT_EQ(read(kRoot / "docs" / "instructions.md"), instruction_reference(instruction_set()))
      << "run scripts/update-instruction-reference";
}

}  // namespace
}  // namespace lanescope
