// SPDX-License-Identifier: MIT
// Meshes in meshes/, as programs wrote them: what is the same in several of them, and what comes of
// them when bytes change.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "simulator/base/error.h"
#include "simulator/base/random.h"
#include "tests/workloads/geometry/mesh_probe.h"
#include "workloads/geometry/mesh.h"

namespace lanescope {
namespace {

const std::filesystem::path kMeshes = LANESCOPE_SOURCE_DIR "/tests/workloads/geometry/meshes";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TriangleMesh read(const std::string& name) { return load_mesh(kMeshes / (name + ".obj")); }

std::string refusal(const std::string& name) {
  try {
    read(name);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(kMeshes.string().size() + 1);
  }
  return "no error";
}

/// Bit for bit.
void expect_same(const std::string& name, const std::string& other) {
  SCOPED_TRACE(name + " and " + other);
  const TriangleMesh a = read(name), b = read(other);
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshCorner &p = a.triangles[t][k], &q = b.triangles[t][k];
      EXPECT_EQ(length(p.position - q.position), 0.0f) << t << ' ' << k;
      EXPECT_EQ(length(p.normal - q.normal), 0.0f) << t << ' ' << k;
    }
}

TEST(MeshFiles, SayTheSameInOtherWords) {
  expect_same("ngon-300", "ngon-300-fans");
  for (const char* name : {"cr-only", "bom", "free-form", "stray-vertex", "origin-marker"})
    expect_same(name, "cube");
  expect_same("map-coordinates", "map-coordinates-local");
}

TEST(MeshFiles, HaveTheirTriangles) {
  const std::map<std::string, std::size_t> expected = {
      {"continuation", 3}, {"backslash-names", 1},   {"underflow", 1},
      {"nan-normals", 14}, {"zero-for-none", 2},     {"statements-not-in-list", 4},
      {"short-faces", 4},  {"concave-u", 6},         {"empty-slashes", 2},
      {"form-feed", 1},    {"sheet-from-behind", 2}, {"inside-out", 12},
  };
  for (const auto& [name, triangles] : expected)
    EXPECT_EQ(read(name).triangles.size(), triangles) << name;
}

/// The U is cut as by hand, in another order.
TEST(MeshFiles, ConcaveFacesAreFilled) {
  const auto middles = [](const std::string& name) {
    std::vector<std::array<float, 2>> all;
    for (const MeshTriangle& t : read(name).triangles) {
      const Vec3 middle = t[0].position + t[1].position + t[2].position;
      all.push_back({std::round(1000.0f * middle.x), std::round(1000.0f * middle.y)});
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(middles("concave-u"), middles("concave-u-cut"));
}

TEST(MeshFiles, AreRefusedForWhatTheyAre) {
  EXPECT_EQ(refusal("cr-hides-face"),
            "cr-hides-face.obj:5: vertex 70000 of a face, but the file has 3 vertices");
  EXPECT_EQ(refusal("hash-qnan"),
            "hash-qnan.obj:4: '1.#QNAN' is not a number; use finite coordinates");
  EXPECT_EQ(refusal("utf16"), "utf16.obj: is UTF-16 text; save it as UTF-8");
  EXPECT_EQ(refusal("gzip"), "gzip.obj: is compressed with gzip; unpack it with gunzip");
}

/// Vertices that no face uses have no say in what is seen, and are told of.
TEST(MeshFiles, UnusedVerticesAreCounted) {
  const std::string note = read("stray-vertex").notes.at(0);
  EXPECT_TRUE(
      note.ends_with("stray-vertex.obj: 1 of 9 vertices is used by no face and left out of "
                     "view"))
      << note;
}

/// One to eight changes, most of them with what matters in these files.
std::string mutated(std::string text, std::uint64_t seed) {
  static const std::string kPieces[] = {
      "\n",    "\r",  "\\\n",    "\f",           "\v",        "#",           "f ",
      "v ",    "vn ", "vt ",     "//",           "/",         "-1 ",         "0 ",
      "1 ",    "9 ",  "nan",     "1e999",        "1e-999",    "1.#IND",      "inf ",
      "l 1 2", "g x", "curv 1 ", "\xef\xbb\xbf", "f 1 2 3\n", "4294967296 ", "-2147483648 "};
  std::uint64_t state = mix64(seed);
  const auto random = [&](std::size_t n) { return (state = mix64(state + 1)) % n; };
  const std::size_t changes = 1 + random(8);
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t place = random(text.size() + 1);
    switch (random(4)) {
      case 0:
        text.erase(place, random(12));
        break;
      case 1:
        text.insert(place, text.substr(random(text.size() + 1), random(40)));
        break;
      case 2:
        if (place < text.size()) text[place] = static_cast<char>(random(256));
        break;
      default:
        text.insert(place, kPieces[random(std::size(kPieces))]);
    }
  }
  return text;
}

/// Most of these are refused, and none does harm: the sanitized build would see it.
TEST(MeshFiles, ChangedBytesAreReadOrRefused) {
  constexpr std::uint64_t kMutations = 300;
  std::size_t read = 0, refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kMeshes)) {
    if (entry.path().extension() != ".obj") continue;
    const std::string text = text_of(entry.path());
    for (std::uint64_t seed = 0; seed < kMutations; ++seed) {
      SCOPED_TRACE(entry.path().string() + ' ' + std::to_string(seed));
      ++(test::probe_mesh(mutated(text, seed)) ? read : refused);
    }
  }
  EXPECT_GT(read, 300u);
  EXPECT_GT(refused, 300u);
}

}  // namespace
}  // namespace lanescope
