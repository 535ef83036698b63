// SPDX-License-Identifier: MIT
// A table of bad meshes and the exact messages.
#include <gtest/gtest.h>

#include <string>

#include "simulator/base/error.h"
#include "workloads/geometry/mesh.h"

namespace lanescope {
namespace {

struct BadMesh {
  std::string text;
  std::string message;
};

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

const BadMesh kBadMeshes[] = {
    {"", "m.obj: is empty; use a Wavefront OBJ file"},
    {"# nothing\n", "m.obj: has no vertices; a mesh needs lines 'v x y z'"},
    {kVertices, "m.obj: has no faces; a mesh needs lines 'f a b c'"},
    {"f 1 2 3\n", "m.obj: has no vertices; a mesh needs lines 'v x y z'"},
    {"v 1 2\n", "m.obj:1: a vertex of 2 coordinates; use 'v x y z'"},
    {"v\n", "m.obj:1: a vertex of 0 coordinates; use 'v x y z'"},
    {"v 1 2 abc\n", "m.obj:1: 'abc' is not a number"},
    {"v 1 2 3,5\n", "m.obj:1: '3,5' is not a number"},
    {"v 1 2 nan\n", "m.obj:1: 'nan' is not a finite coordinate"},
    {"v 1 -inf 3\n", "m.obj:1: '-inf' is not a finite coordinate"},
    {"v 1 1e99 3\n", "m.obj:1: '1e99' is not a number"},
    {"\n\nvn 0 1\n", "m.obj:3: a normal of 2 coordinates; use 'vn x y z'"},
    {"vn 0 1 x\n", "m.obj:1: 'x' is not a number"},
    {kVertices + "f 1 2\n", "m.obj:4: a face of 2 corners; use 3 or more"},
    {kVertices + "f\n", "m.obj:4: a face of 0 corners; use 3 or more"},
    {kVertices + "f 1 2 4\n", "m.obj:4: vertex 4 of a face, but the file has 3 vertices"},
    {kVertices + "f 1 2 99999999999\n",
     "m.obj:4: vertex 99999999999 of a face, but the file has 3 vertices"},
    {kVertices + "f 1 2 0\n", "m.obj:4: index 0 in '0'; indices start at 1"},
    {kVertices + "f 1 2 -4\n", "m.obj:4: vertex -4 counts back past the first of 3 vertices"},
    {kVertices + "f 1//1 2//1 3//1\n", "m.obj:4: normal 1 of a face, but the file has 0 normals"},
    {kVertices + "vn 0 0 1\nf 1//1 2//-2 3//1\n",
     "m.obj:5: normal -2 counts back past the first of 1 normals"},
    {kVertices + "f 1 2 x\n", "m.obj:4: 'x' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "f 1 2 3//\n",
     "m.obj:4: '3//' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "f 1 2 3/1/1/1\n",
     "m.obj:4: '3/1/1/1' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "f 1 2 3.5\n",
     "m.obj:4: '3.5' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "face 1 2 3\n", "m.obj:4: 'face' is not a statement of an OBJ file"},
    {kVertices + "usemtll red\nf 1 2 3\n",
     "m.obj:4: 'usemtll' is not a statement of an OBJ file; did you mean 'usemtl'?"},
    {"solid cube\n", "m.obj:1: 'solid' is not a statement of an OBJ file"},
    {std::string("v 0 0 0\nv \0 1 1\n", 16), "m.obj: is not a text file; use a Wavefront OBJ file"},
    {"\x01\x02\x03 garbage\n", "m.obj:1: '\?\?\?' is not a statement of an OBJ file"},
    {"a-word-that-goes-on-and-on-and-on\n",
     "m.obj:1: 'a-word-that-goes-on-and-...' is not a statement of an OBJ file"},
    {kVertices + "f 1 2 \\\n3\n",
     "m.obj:4: a line that goes on with '\\' cannot be read; join it with the next"},
    {"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "m.obj: has all its vertices in one point"},
    {"v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 1 2\n", "m.obj: has 2 faces, all of zero area"},
    {"v 0 0 0\nv 1e20 0 0\nv 0 1 0\nf 1 2 3\n",
     "m.obj: reaches over 1e+20 units; scale it to 1e15 or less"},
    {"v -3e38 0 0\nv 3e38 0 0\nv 0 1 0\nf 1 2 3\n",
     "m.obj: reaches over inf units; scale it to 1e15 or less"},
};

TEST(BadMesh, EachHasItsMessage) {
  for (const BadMesh& bad : kBadMeshes) {
    try {
      parse_obj(bad.text, "m.obj");
      ADD_FAILURE() << "no error: " << bad.message;
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()), bad.message);
    }
  }
}

std::string load_message(const std::string& path) {
  try {
    load_mesh_scene(path, MeshPatches::kLinear);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(BadMesh, FilesThatCannotBeRead) {
  EXPECT_EQ(load_message("no/such/file.obj"),
            "no/such/file.obj: cannot be opened: No such file or directory");
  EXPECT_EQ(load_message("bunny.stl"),
            "bunny.stl: is not a mesh file that can be read; use a Wavefront OBJ file (.obj)");
  EXPECT_EQ(load_message(""),
            ": is not a mesh file that can be read; use a Wavefront OBJ file (.obj)");
}

}  // namespace
}  // namespace lanescope
