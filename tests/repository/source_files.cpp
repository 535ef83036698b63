// SPDX-License-Identifier: MIT
#include "tests/repository/source_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

namespace lanescope::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = LANESCOPE_SOURCE_DIR;

}  // namespace

std::string read_text(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void for_each_source(std::string_view folder,
                     const std::function<void(const std::string&, const std::string&)>& f) {
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp" && extension != ".in") continue;
    ++seen;
    f(fs::relative(entry.path(), kRoot).generic_string(), read_text(entry.path()));
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

}  // namespace lanescope::test
