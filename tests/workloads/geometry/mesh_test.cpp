// SPDX-License-Identifier: MIT
#include "workloads/geometry/mesh.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/scratch_directory.h"
#include "tests/workloads/micropolygons/tessellation.h"

namespace lanescope {
namespace {

const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";

TEST(ParseObj, CutsPolygonsIntoFans) {
  EXPECT_EQ(parse_obj(kCube, "cube.obj").triangles.size(), 12u);
  const std::string pentagon = "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv -1 1 0\nf 1 2 3 4 5\n";
  EXPECT_EQ(parse_obj(pentagon, "p.obj").triangles.size(), 3u);
}

TEST(ParseObj, ReadsEveryFormOfCornerAndSkipsWhatItDoesNotUse) {
  const std::string text =
      "# a comment\r\nmtllib none.mtl\no thing\ng side\nusemtl red\ns 1\n"
      "v 0 0 0 1 0 0\nv +1 0 0\nv 0 1e0 0\nvt 0 0\nvn 0 0 1\n"
      "f 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -3 -2 -1 # relative\n";
  EXPECT_EQ(parse_obj(text, "m.obj").triangles.size(), 4u);
}

TEST(ParseObj, FitsTheMeshIntoTheUnitSphere) {
  const std::string far = "v 1e6 5 5\nv 1000004 5 5\nv 1e6 8 5\nf 1 2 3\n";
  float longest = 0.0f;
  for (const auto& triangle : parse_obj(far, "m.obj").triangles)
    for (const TriangleMesh::Corner& corner : triangle)
      longest = std::max(longest, length(corner.position));
  EXPECT_NEAR(longest, 1.0f, 1e-5f);
}

TEST(ParseObj, AveragesNormalsWhereTheFileHasNone) {
  for (const auto& triangle : parse_obj(kCube, "cube.obj").triangles)
    for (const TriangleMesh::Corner& corner : triangle) {
      EXPECT_NEAR(length(corner.normal), 1.0f, 1e-5f);
      EXPECT_GT(dot(corner.normal, corner.position), 0.5f) << "outward";
    }
}

TEST(ParseObj, TakesTheNormalsOfTheFile) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nvn 0 0 0\nf 1//1 2//1 3//2\n";
  const auto triangle = parse_obj(text, "m.obj").triangles.at(0);
  EXPECT_FLOAT_EQ(triangle[0].normal.y, 0.6f);
  EXPECT_FLOAT_EQ(triangle[2].normal.z, 1.0f) << "a zero normal is replaced";
}

class EveryKindOfPatch : public ::testing::TestWithParam<MeshPatches> {};
INSTANTIATE_TEST_SUITE_P(MeshPatches, EveryKindOfPatch,
                         ::testing::Values(MeshPatches::kLinear, MeshPatches::kPn,
                                           MeshPatches::kPhong));

TEST_P(EveryKindOfPatch, PassesThroughTheCorners) {
  const TriangleMesh mesh = parse_obj(kCube, "cube.obj");
  const std::unique_ptr<Surface> surface = make_mesh_surface(mesh, GetParam());
  ASSERT_EQ(surface->patch_count(), 36);
  for (int patch = 0; patch < 36; ++patch) {
    SurfacePoint point;
    surface->evaluate(patch, {0.0f, 0.0f, 1.0f, 1.0f, 1, 1}, &point);
    const auto triangle = static_cast<std::size_t>(patch / 3);
    const auto corner = static_cast<std::size_t>(patch % 3);
    const Vec3 expected = mesh.triangles[triangle][corner].position;
    EXPECT_NEAR(length(point.position - expected), 0.0f, 1e-6f);
  }
}

TEST_P(EveryKindOfPatch, ThreePatchesMeetInTheMiddle) {
  const std::unique_ptr<Surface> surface =
      make_mesh_surface(parse_obj(kCube, "cube.obj"), GetParam());
  SurfacePoint middle[3];
  for (int patch = 0; patch < 3; ++patch)
    surface->evaluate(patch, {1.0f, 1.0f, 1.0f, 1.0f, 1, 1}, &middle[patch]);
  EXPECT_NEAR(length(middle[0].position - middle[1].position), 0.0f, 1e-6f);
  EXPECT_NEAR(length(middle[0].position - middle[2].position), 0.0f, 1e-6f);
}

TEST_P(EveryKindOfPatch, AFileBecomesAFramedScene) {
  const testing::ScratchDirectory scratch;
  const std::string path = scratch / "cube.obj";
  std::ofstream(path) << kCube;
  const Scene scene = load_mesh_scene(path, GetParam());
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
}

}  // namespace
}  // namespace lanescope
