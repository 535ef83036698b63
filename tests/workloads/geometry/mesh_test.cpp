// SPDX-License-Identifier: MIT
#include "workloads/geometry/mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace lanescope {
namespace {

const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";

TEST(ParseObj, CutsPolygonsIntoTriangles) {
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
    for (const MeshCorner& corner : triangle) longest = std::max(longest, length(corner.position));
  EXPECT_NEAR(longest, 1.0f, 1e-5f);
}

TEST(ParseObj, AveragesNormalsWhereTheFileHasNone) {
  for (const auto& triangle : parse_obj(kCube, "cube.obj").triangles)
    for (const MeshCorner& corner : triangle) {
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

/// The points of an edge between two triangles, as each of them has them.
std::vector<std::array<Vec3, 2>> points_of_edge(const TriangleMesh& mesh, MeshPatches patches) {
  // Corner 0 of the first triangle is corner 1 of the second, and corner 1 is corner 0 there.
  const std::unique_ptr<Surface> surface = make_mesh_surface(mesh, patches);
  std::vector<std::array<Vec3, 2>> points;
  for (float t = 0.0f; t <= 1.0f; t += 0.125f) {
    SurfacePoint here, there;
    // Patch 0 has the first half of the edge along u; seen from the other side it is the second
    // half, which leads along v from corner 1.
    surface->evaluate(0, {t, 0.0f, 1.0f, 1.0f, 1, 1}, &here);
    surface->evaluate(3 + 1, {0.0f, t, 1.0f, 1.0f, 1, 1}, &there);
    points.push_back({here.position, there.position});
  }
  return points;
}

TEST_P(EveryKindOfPatch, NeighboursMeetWhereNormalsAreSplit) {
  // The rim of a cylinder: a cap with its own normal, and a side with others.
  const std::string text =
      "v 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 -1 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 1\n"
      "f 1//1 2//1 3//1\nf 2//3 1//2 4//3\n";
  const std::string same_points_twice =
      "v 1 0 0\nv 0 0 1\nv 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 -1 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 1\n"
      "f 1//1 2//1 3//1\nf 4//3 5//2 6//3\n";
  for (const std::string& cylinder : {text, same_points_twice}) {
    const TriangleMesh mesh = parse_obj(cylinder, "m.obj");
    float bulge = 0.0f;
    for (const auto& [here, there] : points_of_edge(mesh, GetParam())) {
      EXPECT_NEAR(length(here - there), 0.0f, 1e-6f);
      const Vec3 a = mesh.triangles[0][0].position, b = mesh.triangles[0][1].position;
      bulge = std::max(bulge, length(cross(here - a, b - a)));
    }
    const bool is_round = GetParam() != MeshPatches::kLinear;
    EXPECT_EQ(bulge > 0.05f, is_round) << bulge;
  }
}

/// On an edge of its own a patch is the cubic with control points a third of the way, moved onto
/// the tangent planes at the ends.
TEST(PnPatches, EdgesAreTheCubicsOfTheirNormals) {
  const TriangleMesh mesh = parse_obj(
      "v 0 0 0\nv 3 0 0\nv 0 3 0\nvn 3 0 4\nvn 0 3 4\nvn 0 0 1\nf 1//1 2//2 3//3\n", "m.obj");
  const auto onto_plane = [](const MeshCorner& c, Vec3 p) {
    return p - c.normal * dot(p - c.position, c.normal);
  };
  const MeshCorner &a = mesh.triangles[0][0], &b = mesh.triangles[0][1];
  const Vec3 from_a = onto_plane(a, mix(a.position, b.position, 1.0f / 3.0f));
  const Vec3 from_b = onto_plane(b, mix(b.position, a.position, 1.0f / 3.0f));
  const std::unique_ptr<Surface> surface = make_mesh_surface(mesh, MeshPatches::kPn);
  SurfacePoint middle;
  surface->evaluate(0, {1.0f, 0.0f, 1.0f, 1.0f, 1, 1}, &middle);
  const Vec3 expected = (a.position + b.position) * 0.125f + (from_a + from_b) * 0.375f;
  EXPECT_NEAR(length(middle.position - expected), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace lanescope
