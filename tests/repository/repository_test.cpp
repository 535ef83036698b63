// SPDX-License-Identifier: MIT
// What holds of the repository itself: how long files are, and that generated documents are
// current.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "analysis/machines/cost_tables.h"
#include "simulator/base/error.h"
#include "simulator/instruction_reference.h"
#include "tests/repository/source_files.h"

namespace lanescope {
namespace {

const std::filesystem::path kRoot = LANESCOPE_SOURCE_DIR;

TEST(Sources, AreOfReadableLength) {
  for (const char* folder : {"simulator", "workloads", "kernels", "analysis"}) {
    test::for_each_source(folder, [](const std::string& path, const std::string& text) {
      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 500) << path;
      EXPECT_NE(text.find("SPDX-License-Identifier: MIT"), std::string::npos)
          << path << " names no licence";
    });
  }
}

/// docs/instructions.md is made from the structs, and nothing else is in it.
TEST(Documents, TheInstructionReferenceIsCurrent) {
  EXPECT_EQ(test::read_text(kRoot / "docs" / "instructions.md"),
            instruction_reference(reference_entries(), machine_prices))
      << "run scripts/update-instruction-reference";
}

}  // namespace
}  // namespace lanescope
