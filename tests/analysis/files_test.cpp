// SPDX-License-Identifier: MIT
#include "analysis/base/files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "simulator/base/error.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return directory_ / name; }
  std::size_t entries() const { return directory_.entries().size(); }

 private:
  const testing::ScratchDirectory directory_;
};

TEST_F(Files, AppearWhole) {
  write_file(path("a"), "one");
  write_file(path("a"), "two");
  EXPECT_EQ(read_file(path("a")), "two");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, AreWrittenPieceByPiece) {
  AtomicFile file(path("a"));
  file.append("one ");
  file.append("two ");
  EXPECT_FALSE(fs::exists(path("a")));
  file.commit("three");
  EXPECT_EQ(read_file(path("a")), "one two three");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, AreLeftAloneUnlessCommitted) {
  write_file(path("a"), "one");
  {
    AtomicFile file(path("a"));
    file.append("two");
    EXPECT_EQ(entries(), 2u);
  }
  EXPECT_EQ(read_file(path("a")), "one");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, UnwritablePlacesAreFoundAtOnce) {
  EXPECT_THROW(AtomicFile(path("missing/a")), InputError);
  EXPECT_THROW(AtomicFile(path("")), InputError);
  EXPECT_THROW(AtomicFile(""), InputError);
}

TEST_F(Files, DirectoriesCannotBeRead) {
  try {
    read_file(path(""));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), path("") + ": is a directory; a file is needed");
  }
}

TEST_F(Files, DirectoriesAreMadeWithTheirParents) {
  make_directory(path("a/b"));
  make_directory(path("a/b"));
  write_file(path("a/b/c"), "x");
  EXPECT_THROW(make_directory(path("a/b/c")), InputError);
}

}  // namespace
}  // namespace lanescope
