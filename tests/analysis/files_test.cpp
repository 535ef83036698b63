// SPDX-License-Identifier: MIT
#include "analysis/base/files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

/// An empty directory that goes away with the test.
class Files : public ::testing::Test {
 protected:
  Files() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = fs::path(::testing::TempDir()) / ("lanescope-files-" + std::string(test->name()));
    fs::remove_all(directory_);
    fs::create_directory(directory_);
  }
  ~Files() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return directory_ / name; }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_), fs::directory_iterator()));
  }

 private:
  fs::path directory_;
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
