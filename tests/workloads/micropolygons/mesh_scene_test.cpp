// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/mesh_scene.h"

#include <gtest/gtest.h>

#include <fstream>

#include "simulator/base/error.h"
#include "tests/scratch_directory.h"
#include "tests/workloads/micropolygons/tessellation.h"

namespace lanescope {
namespace {

const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";
const std::string kInsideOut = kCube.substr(0, kCube.find('f')) +
                               "f 8 7 6 5\nf 3 4 1 2\nf 7 3 2 6\nf 4 8 5 1\nf 4 3 7 8\nf 5 6 2 1\n";

class AMeshScene : public ::testing::Test {
 protected:
  std::string path() const { return scratch_ / "m.obj"; }
  Scene load(const std::string& text, MeshPatches patches = MeshPatches::kPn) {
    std::ofstream(path()) << text;
    return load_mesh_scene(path(), patches);
  }
  /// The only note, without the file.
  std::string note(const std::string& text) {
    const Scene scene = load(text);
    return scene.notes.size() == 1 ? scene.notes[0].substr(path().size()) : "not one";
  }

 private:
  testing::ScratchDirectory scratch_;
};

TEST_F(AMeshScene, IsFramed) {
  for (const auto& choice : kMeshPatches) {
    const Scene scene = load(kCube, choice.value);
    const TessellationOptions options = test::small_options(Micropolygon::kTriangle);
    const test::Tessellation t = test::tessellate(scene, options);
    double front = 0.0;
    for (const test::Polygon& p : t.polygons) {
      if (p.area() > 0.0) front += p.area() / 4.0;
      for (int i = 0; i < 3; ++i) {
        ASSERT_GE(p.y(i), 0.0f);
        ASSERT_LE(p.y(i), 2.0f * static_cast<float>(options.height_px));
      }
    }
    const double frame_px = double{1} * options.width_px * options.height_px;
    EXPECT_GT(front / frame_px, 0.15) << "fills a good part of the frame";
    EXPECT_EQ(t.counts.dropped, 0u);
    EXPECT_TRUE(scene.notes.empty());
  }
}

TEST_F(AMeshScene, SaysWhatOfTheFileWasSkipped) {
  EXPECT_EQ(note(kCube + "l 1 2\n"),
            ": skipped 1 point, line, curve or surface (first in line 15)");
}

TEST_F(AMeshScene, SaysWhyNothingIsSeen) {
  EXPECT_EQ(note("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 4 3 2 1\n"),
            ": nothing faces the viewer; 2 of its triangles are seen from behind, and drawn only "
            "with --cull off");
  EXPECT_EQ(
      note(kInsideOut),
      ": most faces look away; 100% of what the viewer meets first are backs, which are drawn "
      "only with --cull off");
}

/// The tessellator keeps whole patches in a few runs, and divides them as it would one by one.
TEST_F(AMeshScene, ManyTrianglesAreDividedIntoSegments) {
  std::string text;
  constexpr int kSide = 220;
  for (int i = 0; i <= kSide; ++i)
    for (int j = 0; j <= kSide; ++j)
      text += std::to_string(j).insert(0, "v ") + " " + std::to_string(i) + " 0\n";
  for (int i = 0; i < kSide; ++i)
    for (int j = 1; j <= kSide; ++j) {
      const int a = i * (kSide + 1) + j;
      text += fmt::format("f {} {} {} {}\n", a, a + 1, a + kSide + 2, a + kSide + 1);
    }
  const Scene scene = load(text, MeshPatches::kLinear);
  TessellationOptions options = test::small_options(Micropolygon::kTriangle);
  const Tessellator tessellator(scene, options);
  EXPECT_GT(tessellator.segment_count(), 4);
  std::uint64_t grids = 0;
  for (int segment = 0; segment < tessellator.segment_count(); ++segment) {
    const std::uint64_t here = tessellator.tessellate(segment, [](const Packet&) {}).grids;
    EXPECT_GT(here, 1000u) << segment;
    grids += here;
  }
  EXPECT_EQ(grids, 3u * 2u * kSide * kSide) << "every patch once";
}

}  // namespace
}  // namespace lanescope
