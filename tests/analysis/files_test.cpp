// SPDX-License-Identifier: MIT
#include "analysis/base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

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
  OutputFile file(path("a"));
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
    OutputFile file(path("a"));
    file.append("two");
    EXPECT_EQ(entries(), 2u);
  }
  EXPECT_EQ(read_file(path("a")), "one");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, UnwritablePlacesAreFoundAtOnce) {
  EXPECT_THROW(OutputFile(path("missing/a")), InputError);
  EXPECT_THROW(OutputFile(path("")), InputError);
  EXPECT_THROW(OutputFile(""), InputError);
}

TEST_F(Files, KeepTheirPermissions) {
  write_file(path("a"), "one");
  fs::permissions(path("a"), fs::perms::owner_read | fs::perms::owner_write);
  write_file(path("a"), "two");
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, AreWrittenWhereLinksLead) {
  fs::create_directory(path("d"));
  write_file(path("d/there"), "old");
  fs::create_symlink("d/there", path("link"));
  fs::create_symlink("link", path("second"));
  fs::create_symlink("d/new", path("dangling"));
  write_file(path("second"), "one");
  write_file(path("dangling"), "two");
  EXPECT_TRUE(fs::is_symlink(path("second")) && fs::is_symlink(path("link")) &&
              fs::is_symlink(path("dangling")));
  EXPECT_EQ(read_file(path("d/there")), "one");
  EXPECT_EQ(read_file(path("d/new")), "two");
  fs::create_symlink("round", path("round"));
  EXPECT_THROW(OutputFile(path("round")), InputError);
}

TEST_F(Files, OfOneNameAreNotWrittenTwiceAtATime) {
  const OutputFile first(path("a"));
  try {
    OutputFile second(path("a"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), path("a") + ": is given as the file of two outputs");
  }
}

TEST_F(Files, OfLongNamesAreWritten) {
  const std::string longest(255, 'a');
  write_file(path(longest), "one");
  EXPECT_EQ(read_file(path(longest)), "one");
}

TEST_F(Files, AreClearedWhenASignalEndsTheProcess) {
  write_file(path("b"), "old");
  const OutputFile file(path("a"));
  const OutputFile other(path("b"));
  EXPECT_EQ(entries(), 3u);
  remove_temporary_files();
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, PipesAreWrittenInto) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::string read;
  std::jthread reader([&] {
    std::ifstream pipe(path("pipe"));
    std::getline(pipe, read, '\0');
  });
  write_file(path("pipe"), "through the pipe");
  reader.join();
  EXPECT_EQ(read, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, DevicesStayDevices) {
  constexpr int kNull = 3, kFull = 7;  // Of the memory devices, 1.
  if (::mknod(path("null").c_str(), S_IFCHR | 0600, ::makedev(1, kNull)) != 0 ||
      ::mknod(path("full").c_str(), S_IFCHR | 0600, ::makedev(1, kFull)) != 0 ||
      ::access(path("null").c_str(), W_OK) != 0 || !std::ofstream(path("null")))
    GTEST_SKIP() << "devices of our own cannot be made here";
  write_file(path("null"), "nothing");
  EXPECT_TRUE(fs::is_character_file(path("null")));
  EXPECT_THROW(write_file(path("full"), "too much"), InputError);
  EXPECT_TRUE(fs::is_character_file(path("full")));
  EXPECT_EQ(entries(), 2u);
}

TEST_F(Files, WithoutANameAreWrittenThroughTheirDescriptor) {
  const int file = ::open(path("a").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_GE(file, 0);
  fs::remove(path("a"));
  write_file(fmt::format("/proc/self/fd/{}", file), "no name any more");
  struct stat status {};
  ASSERT_EQ(::fstat(file, &status), 0);
  EXPECT_EQ(status.st_size, 16);
  EXPECT_EQ(entries(), 0u);
  ::close(file);
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
