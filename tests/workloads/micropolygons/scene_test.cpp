// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "simulator/base/error.h"
#include "tests/workloads/micropolygons/tessellation.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

TEST(Scenes, HaveNamesSummariesAndFrames) {
  std::set<std::string_view> names;
  for (const SurfaceScene* scene : surface_scenes()) {
    EXPECT_TRUE(names.insert(scene->name).second) << scene->name;
    EXPECT_FALSE(scene->summary.empty());
    EXPECT_GE(scene->default_frame, 0);
    EXPECT_LT(scene->default_frame, scene->frame_count);
  }
}

TEST(Scenes, MoveFromFrameToFrame) {
  for (const SurfaceScene* descriptor : surface_scenes()) {
    TessellationOptions options = test::small_options(Micropolygon::kQuad);
    options.width_px = 96;
    options.height_px = 60;
    const Scene first = descriptor->build(0), last = descriptor->build(descriptor->frame_count - 1);
    const auto a = test::tessellate(first, options), b = test::tessellate(last, options);
    EXPECT_EQ(a.counts.dropped + b.counts.dropped, 0u) << descriptor->name;
    const bool same = a.polygons.size() == b.polygons.size() &&
                      std::equal(a.polygons.begin(), a.polygons.end(), b.polygons.begin(),
                                 [](const test::Polygon& p, const test::Polygon& q) {
                                   return p.vertex[0].attributes == q.vertex[0].attributes;
                                 });
    EXPECT_FALSE(same) << descriptor->name;
  }
}

TEST(FindScene, FindsEveryScene) {
  for (const SurfaceScene* scene : surface_scenes())
    EXPECT_EQ(&find_surface_scene(scene->name), scene);
}

TEST(FindScene, SuggestsTheNearestName) {
  try {
    find_surface_scene("teapt");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "--scene: no scene is called 'teapt'; did you mean 'teapot'?");
  }
  EXPECT_THROW(find_surface_scene("xyzzy"), InputError);
}

}  // namespace
}  // namespace lanescope
