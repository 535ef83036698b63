// SPDX-License-Identifier: MIT
// A fixture that runs the program in an empty directory, which goes away with the test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "analysis/base/files.h"
#include "tests/cli/program.h"

namespace lanescope::testing {

class InEmptyDirectory : public ::testing::Test {
 protected:
  InEmptyDirectory() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = std::filesystem::path(::testing::TempDir()) /
                 (std::string("lanescope-") + test->test_suite_name() + "-" + test->name());
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directory(directory_);
  }
  ~InEmptyDirectory() override { std::filesystem::remove_all(directory_); }

  /// Runs the program there and expects that it ends with that status.
  Outcome run(const std::string& arguments, int status = 0) const {
    Outcome outcome = lanescope_program(arguments, directory_);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.errors;
    return outcome;
  }
  std::string file(const std::string& name) const { return read_file(directory_ / name); }
  void write(const std::string& name, const std::string& text) const {
    write_file(directory_ / name, text);
  }
  std::set<std::string> entries(const std::string& below = "") const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory_ / below))
      names.insert(entry.path().filename());
    return names;
  }
  const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
};

}  // namespace lanescope::testing
