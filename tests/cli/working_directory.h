// SPDX-License-Identifier: MIT
// A fixture that runs the program in an empty directory, which goes away with the test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "analysis/base/files.h"
#include "tests/cli/program.h"
#include "tests/scratch_directory.h"

namespace lanescope::testing {

class InEmptyDirectory : public ::testing::Test {
 protected:
  /// Runs the program there and expects that it ends with that status.
  Outcome run(const std::string& arguments, int status = 0) const {
    Outcome outcome = lanescope_program(arguments, directory());
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.errors;
    return outcome;
  }
  std::string file(const std::string& name) const { return read_file(directory_ / name); }
  void write(const std::string& name, const std::string& text) const {
    write_file(directory_ / name, text);
  }
  std::set<std::string> entries(const std::string& below = "") const {
    return directory_.entries(below);
  }
  const std::filesystem::path& directory() const { return directory_.path(); }

 private:
  ScratchDirectory directory_;
};

}  // namespace lanescope::testing
