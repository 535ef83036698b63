// SPDX-License-Identifier: MIT
// What the reader takes, what it says of it, and what it refuses with which words.
#include "workloads/geometry/obj_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "simulator/base/error.h"
#include "workloads/geometry/mesh.h"

namespace lanescope {
namespace {

using namespace std::string_literals;

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kTriangle = kVertices + "f 1 2 3\n";

struct BadMesh {
  std::string text;
  std::string message;
};

const BadMesh kBadMeshes[] = {
    {"", "m.obj: is empty; use a Wavefront OBJ file"},
    {"\0\0"s, "m.obj: is empty; use a Wavefront OBJ file"},
    {"# nothing\n", "m.obj: has no vertices; a mesh needs lines 'v x y z'"},
    {kVertices, "m.obj: has no faces; a mesh needs lines 'f a b c'"},
    {kVertices + "l 1 2\nf 1 2\n",
     "m.obj: has no faces; a mesh needs lines 'f a b c'; skipped 1 face of fewer than 3 different "
     "corners (first in line 5); 1 point, line, curve or surface (first in line 4)"},
    {"f 1 2 3\n", "m.obj:1: vertex 1 of a face, but the file has 0 vertices"},
    {"v 1 2\n", "m.obj:1: a vertex of 2 coordinates; use 'v x y z'"},
    {"v\n", "m.obj:1: a vertex of 0 coordinates; use 'v x y z'"},
    {"v 1 2 abc\n", "m.obj:1: 'abc' is not a number; use 'v x y z'"},
    {"v 1 2 3,5\n", "m.obj:1: '3,5' is not a number; use 'v x y z'"},
    {"v 1 2 +-3\n", "m.obj:1: '+-3' is not a number; use 'v x y z'"},
    {"v 1 2 3 1.0 red\n", "m.obj:1: 'red' is not a number; use 'v x y z'"},
    {"v 1 2 nan\n", "m.obj:1: 'nan' is not a number; use finite coordinates"},
    {"v 1 -nan(ind) 3\n", "m.obj:1: '-nan(ind)' is not a number; use finite coordinates"},
    {"v 1.#QNAN 0 1\n", "m.obj:1: '1.#QNAN' is not a number; use finite coordinates"},
    {"v 0 -1.#IND00 1\n", "m.obj:1: '-1.#IND00' is not a number; use finite coordinates"},
    {"v 0 0 1.#QO\n", "m.obj:1: '1.#QO' is not a number; use finite coordinates"},
    {"v 1.#inf 0 1\n", "m.obj:1: '1.#inf' is infinite; use finite coordinates"},
    {"v 1 -inf 3\n", "m.obj:1: '-inf' is infinite; use finite coordinates"},
    {"v 1 1e999 3\n", "m.obj:1: '1e999' is infinite; use finite coordinates"},
    {"v 1 "s + std::string(400, '9') + " 3\n",
     "m.obj:1: '999999999999999999999999...' is infinite; use finite coordinates"},
    {"\n\nvn 0 1\n", "m.obj:3: a normal of 2 coordinates; use 'vn x y z'"},
    {"vn 0 1 x\n", "m.obj:1: 'x' is not a number; use 'vn x y z'"},
    {kVertices + "f 1 2 4\n", "m.obj:4: vertex 4 of a face, but the file has 3 vertices"},
    {kVertices + "f 1 2 4000000000\n",
     "m.obj:4: vertex 4000000000 of a face, but the file has 3 vertices"},
    {kVertices + "f 1 2 99999999999\n",
     "m.obj:4: vertex 99999999999 of a face; a mesh has at most 4294967295 vertices"},
    {kVertices + "f 1 2 0\n", "m.obj:4: index 0 in '0'; vertices are counted from 1"},
    {kVertices + "f 1 2 -4\n", "m.obj:4: vertex -4 counts back past the first of 3 vertices"},
    {kVertices + "f 1 2 -99999999999999999999\n",
     "m.obj:4: vertex -9223372036854775808 counts back past the first of 3 vertices"},
    {kVertices + "f 1 2 x\n", "m.obj:4: 'x' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "f 1 2 /1\n",
     "m.obj:4: '/1' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "f 1 2 3/1/1/1\n",
     "m.obj:4: '3/1/1/1' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "f 1 2 3.5\n",
     "m.obj:4: '3.5' is not a corner of a face; use v, v/t, v//n or v/t/n"},
    {kVertices + "face 1 2 3\n", "m.obj:4: 'face' is not a statement of an OBJ file"},
    {kVertices + "F 1 2 3\n", "m.obj:4: 'F' is not a statement of an OBJ file"},
    {kVertices + "f 1 2\n3\n", "m.obj:5: '3' is not a statement of an OBJ file"},
    {"solid cube\n", "m.obj: is an STL file; convert it to Wavefront OBJ"},
    {"hello\n", "m.obj:1: 'hello' is not a statement of an OBJ file"},
    {"v 0 0 0\nv \0 1 1\n"s, "m.obj: is not a text file; use a Wavefront OBJ file"},
    {"\x01\x02\x03 garbage\n", "m.obj:1: '\?\?\?' is not a statement of an OBJ file"},
    {"1a-word-that-goes-on-and-on-and-on\n",
     "m.obj:1: '1a-word-that-goes-on-and...' is not a statement of an OBJ file"},
    {kVertices + "g lid\rf 1 2 70000\n",
     "m.obj:5: vertex 70000 of a face, but the file has 3 vertices"},
    {kVertices + "f 1 \\\n2 \\\r\n4\r\nv a\n", "m.obj:7: 'a' is not a number; use 'v x y z'"},
    {"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "m.obj: has all vertices of its faces in one point"},
    {"v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 2 3 1\n", "m.obj: has 2 faces, all of zero area"},
    {"v -1.7e308 0 0\nv 1.7e308 0 0\nv 0 1 0\nf 1 2 3\n",
     "m.obj: reaches over more than 1.8e+308 units; scale it down"},
    {"\x1f\x8b\x08 and so on", "m.obj: is compressed with gzip; unpack it with gunzip"},
    {"PK\x03\x04 and so on", "m.obj: is a zip archive; unpack it with unzip"},
    {"ply\nformat ascii 1.0\n", "m.obj: is a PLY file; convert it to Wavefront OBJ"},
    {"\xff\xfev\0 \0"s, "m.obj: is UTF-16 text; save it as UTF-8"},
    {"\xfe\xff\0v\0 "s, "m.obj: is UTF-16 text; save it as UTF-8"},
    {"v\0 \0001\0 \0"s, "m.obj: is UTF-16 text; save it as UTF-8"},
    {"\xff\xfe\0\0v\0\0\0"s, "m.obj: is UTF-32 text; save it as UTF-8"},
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

TEST(BadMesh, FacesThatWouldTakeLongToCut) {
  std::string text = kVertices + "f";
  for (int i = 0; i < 40000; ++i) text += " 1 2 3";
  try {
    read_obj(text, "m.obj");
    ADD_FAILURE();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()),
              "m.obj:4: a face of more than 100000 corners; cut it into several");
  }
}

TEST(BadMesh, FilesThatCannotBeRead) {
  try {
    load_mesh("no/such/file.obj");
    ADD_FAILURE();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()),
              "no/such/file.obj: cannot be opened: No such file or directory");
  }
}

/// The same triangle, as various programs write it.
const std::string kSameTriangle[] = {
    "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
    "v 0 0 0\r\nv 1 0 0\nv 0 1 0\rf 1 2 3",
    "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "v\t0\v0\f0\nv 1 0 0   \n  v 0 1 0\n\n\nf 1 2 3\n",
    "v 0 0 \\\n0\nv 1 \\  \r\n 0 0\nv 0 1 0\nf 1\\\n2 3 \\",
    "v 0 0 0# a\nv 1 0 0 # b\\\nv 0 1 0\n#\nf 1 2 3#c",
    "v 0 0 0 1 0 0\nv +1 0e0 0. 0.5\nv -0 1 .0\nf 1/ 2// 3\n",
    "v 5e-400 0 -0.0000e-9999999999\nv 1 1e-46 0\nv 0 1 0\nf -3 -2/7 +3/-9\n",
    "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2 3 3 1\n",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nfo 1 2 3\n",
    "mtllib a\\b.mtl\no c:\\d\\\nv 0 0 0\nusemtl x\\ y\nv 1 0 0\ng a \\\n b\nv 0 1 0\ns off\nf 1 2 "
    "3\n",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\x1a"s + "\0\0\0"s,
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvp 0.5 \\\n1\nf 1/1 2/1 3/1\n",
};

TEST(ObjReader, TakesWhatExportersWrite) {
  for (const std::string& text : kSameTriangle) {
    SCOPED_TRACE(text);
    const PolygonMesh mesh = read_obj(text, "m.obj");
    ASSERT_EQ(mesh.face_ends, std::vector<std::size_t>{3});
    ASSERT_EQ(mesh.positions.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.corners[i].vertex, i);
      EXPECT_EQ(mesh.corners[i].normal, PolygonMesh::kNone);
    }
    EXPECT_TRUE(mesh.positions[0] == (Point3{0, 0, 0}));
    EXPECT_TRUE(mesh.positions[1] == (Point3{1, text.find("1e-46") != text.npos ? 1e-46 : 0, 0}));
    EXPECT_TRUE(mesh.positions[2] == (Point3{0, 1, 0}));
    EXPECT_EQ(mesh.notes, std::vector<std::string>{});
  }
}

struct Noted {
  std::string text;
  std::string note;
};

const Noted kNoted[] = {
    {"f 1\nf 2 3\nf\nf 1 1 2\n",
     "m.obj: skipped 4 faces of fewer than 3 different corners (first in line 5)"},
    {"p 1\nl 1 2\ncstype bspline\ndeg 3\ncurv 0 1 1 2 3 \\\n 4\nparm u 0 1\nend\n",
     "m.obj: skipped 3 points, lines, curves or surfaces (first in line 5)"},
    {"call other.obj\nt crease 1/0/0\n",
     "m.obj: skipped 2 other statements (first in line 5, 'call')"},
    {"f 1/0 2/0/ 3/0\n", "m.obj: skipped 3 texture indices 0 (first in line 5)"},
    {"f 1//0 2//0 3//0\n",
     "m.obj: corners without a usable normal have the average of the faces there: 3 indices 0 "
     "(first in line 5)"},
    {"vn 0 0 1\nf 1//1 2//2 3//-2\n",
     "m.obj: corners without a usable normal have the average of the faces there: 2 indices of "
     "normals that the file does not hold (first in line 6)"},
    {"vn nan 0 1\nvn 0 0 0\nvn 1.#INF 0 0\nf 1//1 2//2 3//3\n",
     "m.obj: corners without a usable normal have the average of the faces there: 3 normals that "
     "are zero or not finite (first in line 8)"},
};

TEST(ObjReader, CountsWhatItSkipsAndReplaces) {
  for (const Noted& noted : kNoted)
    EXPECT_EQ(read_obj(kTriangle + noted.text, "m.obj").notes,
              std::vector<std::string>{noted.note});
}

TEST(ObjReader, SmallNormalsHaveDirections) {
  const std::string text = kVertices + "vn 3e-200 0 4e-200\nvn 0 3e200 4e200\nf 1//1 2//2 3//1\n";
  const PolygonMesh mesh = read_obj(text, "m.obj");
  EXPECT_FLOAT_EQ(mesh.normals.at(0).x, 0.6f);
  EXPECT_FLOAT_EQ(mesh.normals.at(1).z, 0.8f);
  EXPECT_EQ(mesh.notes, std::vector<std::string>{});
}

TEST(ObjReader, TellsHowFarItIs) {
  std::string text = kTriangle;
  for (int i = 0; i < 100000; ++i) text += "v 0 0 1\n";
  double last = 0.0;
  int calls = 0;
  read_obj(text, "m.obj", [&](double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
    ++calls;
  });
  EXPECT_GT(calls, 4);
  EXPECT_GT(last, 0.8);
  EXPECT_LE(last, 1.0);
}

}  // namespace
}  // namespace lanescope
