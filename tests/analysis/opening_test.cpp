// SPDX-License-Identifier: MIT
// What is heard while a scene is opened.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

TEST(Opening, ALargeMeshShowsProgressAndItsNotes) {
  const testing::ScratchDirectory scratch;
  const std::string path = scratch / "m.obj";
  {
    std::ofstream file(path);
    file << "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n";
    for (int i = 0; i < 40000; ++i) file << "f 1 2 3\n";
  }
  Arguments given;
  given.set("kernel", std::string("lockstep"));
  given.set("scene", path);
  std::vector<double> fractions;
  std::vector<std::string> notes;
  open_source(resolved(given), {[&](double fraction) { fractions.push_back(fraction); },
                                [&](const std::string& note) { notes.push_back(note); }});
  ASSERT_GT(fractions.size(), 10u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LT(fractions.front(), 0.3);
  EXPECT_GT(fractions.back(), 0.9);
  EXPECT_LE(fractions.back(), 1.0);
  EXPECT_EQ(notes, (std::vector<std::string>{
                       path + ": skipped 1 point, line, curve or surface (first in line 4)"}));
}

TEST(Opening, BuiltInScenesHaveNoNotes) {
  Arguments given;
  given.set("kernel", std::string("lockstep"));
  EXPECT_TRUE(open_source(resolved(given))->notes().empty());
}

}  // namespace
}  // namespace lanescope
