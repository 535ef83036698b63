// SPDX-License-Identifier: MIT
// What the reader takes, where cubes come to stand, and what is refused with which words.
#include "workloads/voxels/vox_reader.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "simulator/base/error.h"
#include "simulator/base/random.h"
#include "tests/scratch_directory.h"
#include "tests/workloads/voxels/vox_probe.h"

namespace lanescope {
namespace {

using namespace std::string_literals;

// A writer of files, chunk by chunk. Places in messages are counted by hand: MAIN begins at byte 8,
// its children at 20; the content of a chunk begins 12 bytes after the chunk.

std::string number(std::int64_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 255);
  return bytes;
}

std::string chunk(const std::string& name, const std::string& content,
                  const std::string& children = "") {
  return name + number(std::ssize(content)) + number(std::ssize(children)) + content + children;
}

std::string file_of(const std::string& children, int version = 150) {
  return "VOX " + number(version) + chunk("MAIN", "", children);
}

std::string size_chunk(int x, int y, int z) {
  return chunk("SIZE", number(x) + number(y) + number(z));
}

struct FileCube {
  int x, y, z, colour;
};

std::string cubes_chunk(const std::vector<FileCube>& cubes) {
  std::string content = number(std::ssize(cubes));
  for (const FileCube& c : cubes)
    for (const int part : {c.x, c.y, c.z, c.colour}) content += static_cast<char>(part);
  return chunk("XYZI", content);
}

std::string model(int x, int y, int z, const std::vector<FileCube>& cubes) {
  return size_chunk(x, y, z) + cubes_chunk(cubes);
}

using Attributes = std::vector<std::pair<std::string, std::string>>;

std::string dictionary(const Attributes& attributes) {
  std::string bytes = number(std::ssize(attributes));
  for (const auto& [key, value] : attributes)
    bytes += number(std::ssize(key)) + key + number(std::ssize(value)) + value;
  return bytes;
}

std::string transform(int id, int child, const Attributes& frame, const Attributes& node = {},
                      int layer = -1) {
  return chunk("nTRN", number(id) + dictionary(node) + number(child) + number(-1) + number(layer) +
                           number(1) + dictionary(frame));
}

std::string group(int id, const std::vector<int>& children, const Attributes& node = {}) {
  std::string content = number(id) + dictionary(node) + number(std::ssize(children));
  for (const int child : children) content += number(child);
  return chunk("nGRP", content);
}

std::string shape(int id, int model_id, const Attributes& node = {}) {
  return chunk("nSHP",
               number(id) + dictionary(node) + number(1) + number(model_id) + dictionary({}));
}

std::string layer(int id, const Attributes& attributes) {
  return chunk("LAYR", number(id) + dictionary(attributes) + number(-1));
}

const std::string kCube = model(1, 1, 1, {{0, 0, 0, 1}});

/// x, y, z and colour of every cube.
using Cubes = std::set<std::tuple<int, int, int, int>>;

Cubes cubes_of(const World& world) {
  Cubes cubes;
  for (int z = 0; z < world.size().z; ++z)
    for (int y = 0; y < world.size().y; ++y)
      for (int x = 0; x < world.size().x; ++x)
        if (world.filled({x, y, z})) cubes.emplace(x, y, z, world.colour_number({x, y, z}));
  return cubes;
}

Cubes cubes_of(const std::string& children) {
  return cubes_of(parse_vox("w.vox", file_of(children)));
}

TEST(VoxReader, TurnsZUp) {
  // From (0, 0, 0) of the file one cube to the right, two away from the viewer, three up.
  const std::string children =
      model(2, 3, 4, {{0, 0, 0, 1}, {1, 0, 0, 2}, {0, 2, 0, 3}, {0, 0, 3, 4}});
  const World world = parse_vox("w.vox", file_of(children));
  EXPECT_EQ(world.size(), (Cube{2, 4, 3}));
  EXPECT_EQ(world.margin, 0);
  EXPECT_EQ(cubes_of(world), (Cubes{{0, 0, 2, 1}, {1, 0, 2, 2}, {0, 0, 0, 3}, {0, 3, 2, 4}}));
}

TEST(VoxReader, CropsToTheCubes) {
  EXPECT_EQ(cubes_of(model(200, 200, 200, {{17, 150, 3, 9}, {19, 150, 3, 8}})),
            (Cubes{{0, 0, 0, 9}, {2, 0, 0, 8}}));
}

TEST(VoxReader, TakesBothVersionsAndSkipsWhatItDoesNotKnow) {
  const std::string children = chunk("PACK", number(1)) + chunk("nope", "abc", chunk("deep", "d")) +
                               kCube + chunk("MATL", "") + chunk("IMAP", std::string(256, '\0'));
  for (const int version : {150, 200})
    EXPECT_EQ(parse_vox("w.vox", file_of(children, version)).filled_count(), 1u);
}

TEST(VoxReader, TakesContentThatIsLongerThanItKnows) {
  const std::string size = chunk("SIZE", number(1) + number(1) + number(1) + "more");
  EXPECT_EQ(cubes_of(size + cubes_chunk({{0, 0, 0, 5}})).size(), 1u);
}

TEST(VoxReader, HasTheDefaultPalette) {
  const World world = parse_vox("w.vox", file_of(kCube));
  using Colour = World::Colour;
  const std::vector<std::pair<std::size_t, Colour>> expected = {
      {1, {255, 255, 255}},      {2, {255, 255, 204}},     {6, {255, 255, 0}},
      {7, {255, 204, 255}},      {36, {255, 0, 0}},        {37, {204, 255, 255}},
      {215, {0, 0, 51}},         {216, {0xee, 0, 0}},      {225, {0x11, 0, 0}},
      {226, {0, 0xee, 0}},       {236, {0, 0, 0xee}},      {245, {0, 0, 0x11}},
      {246, {0xee, 0xee, 0xee}}, {255, {0x11, 0x11, 0x11}}};
  for (const auto& [entry, colour] : expected) EXPECT_EQ(world.palette[entry], colour) << entry;
  const std::set<Colour> different(world.palette.begin() + 1, world.palette.end());
  EXPECT_EQ(different.size(), 255u);
}

TEST(VoxReader, TakesTheColourBeforeTheNumber) {
  std::string content;
  for (int i = 0; i < 256; ++i)
    content += {static_cast<char>(i), static_cast<char>(255 - i), static_cast<char>(i / 2), '\xff'};
  const World world = parse_vox("w.vox", file_of(kCube + chunk("RGBA", content)));
  EXPECT_EQ(world.colour({0, 0, 0}), (World::Colour{0, 255, 0}));
  EXPECT_EQ(world.palette[255], (World::Colour{254, 1, 127}));
}

TEST(VoxReader, PutsModelsWhereTheFirstIsWithoutAGraph) {
  EXPECT_EQ(cubes_of(model(4, 4, 4, {{1, 1, 1, 1}, {3, 3, 3, 1}}) +
                     model(2, 2, 2, {{1, 1, 1, 2}, {0, 0, 0, 3}})),
            (Cubes{{0, 0, 3, 3}, {1, 1, 2, 2}, {3, 3, 0, 1}}));
}

TEST(VoxReader, PlacesModelsByTheMiddle) {
  // Size 2 has its middle at 1, size 3 at 1, too: (0, 0, 0) stands at -1.
  const std::string models = model(2, 2, 2, {{0, 0, 0, 1}}) + model(3, 3, 3, {{0, 0, 0, 2}});
  EXPECT_EQ(cubes_of(models + transform(0, 1, {}) + group(1, {2, 4}) +
                     transform(2, 3, {{"_t", "0 0 0"}}) + shape(3, 0) +
                     transform(4, 5, {{"_t", "3 -2 1"}}) + shape(5, 1)),
            (Cubes{{0, 0, 0, 1}, {3, 1, 2, 2}}));
}

TEST(VoxReader, LetsTheLaterWin) {
  const std::string models = model(1, 1, 1, {{0, 0, 0, 1}}) + model(1, 1, 1, {{0, 0, 0, 2}});
  const auto with = [&](int first, int second) {
    return cubes_of(models + group(0, {first, second}) + shape(1, 0) + shape(2, 1));
  };
  EXPECT_EQ(with(1, 2), (Cubes{{0, 0, 0, 2}}));
  EXPECT_EQ(with(2, 1), (Cubes{{0, 0, 0, 1}}));
}

TEST(VoxReader, ShowsAModelSeveralTimes) {
  EXPECT_EQ(cubes_of(kCube + group(0, {1, 3}) + transform(1, 2, {{"_t", "2 0 0"}}) + shape(2, 0) +
                     transform(3, 4, {{"_t", "-1 0 0"}}) + shape(4, 0)),
            (Cubes{{0, 0, 0, 1}, {3, 0, 0, 1}}));
}

TEST(VoxReader, ShowsTheFirstFrame) {
  const std::string frames = number(0) + dictionary({}) + number(1) + number(-1) + number(-1) +
                             number(2) + dictionary({{"_t", "5 0 0"}, {"_f", "0"}}) +
                             dictionary({{"_t", "900000 0 0"}, {"_f", "1"}});
  EXPECT_EQ(cubes_of(kCube + chunk("nTRN", frames) + group(1, {2, 3}) + shape(2, 0) +
                     transform(3, 4, {{"_t", "1 0 0"}}) + shape(4, 0))
                .size(),
            2u);
}

/// As a matrix, of file axes.
struct Rotation {
  int bits;
  int matrix[3][3];
};

TEST(VoxReader, TurnsModels) {
  const Rotation rotations[] = {
      {0b0000100, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {0b0010001, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}},
      {0b0110100, {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
      {0b0001001, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
      {0b1000110, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}},
      {0b1000100, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
  };
  const std::vector<FileCube> cubes = {{0, 0, 0, 1}, {1, 0, 0, 2}, {0, 2, 0, 3}, {0, 0, 4, 4}};
  for (const Rotation& rotation : rotations) {
    const auto& m = rotation.matrix;
    // A cube far off, which stays where it is, shows how far the others move.
    Cubes expected;
    for (const FileCube& c : cubes) {
      const int from_middle[] = {2 * (c.x - 1) + 1, 2 * (c.y - 1) + 1, 2 * (c.z - 2) + 1};
      int to[3];
      for (int i = 0; i < 3; ++i)
        to[i] =
            (m[i][0] * from_middle[0] + m[i][1] * from_middle[1] + m[i][2] * from_middle[2] - 1) /
            2;
      expected.emplace(20 + to[0] + 7, 20 + to[2], 20 - to[1], c.colour);
    }
    expected.emplace(0, 0, 0 + 40, 9);
    expected.emplace(40, 40, 0, 9);
    const std::string graph =
        group(0, {1, 3, 5}) +
        transform(1, 2, {{"_r", std::to_string(rotation.bits)}, {"_t", "7 0 0"}}) + shape(2, 0) +
        transform(3, 4, {{"_t", "-20 -20 -20"}}) + shape(4, 1) +
        transform(5, 6, {{"_t", "20 20 20"}}) + shape(6, 1);
    EXPECT_EQ(cubes_of(model(2, 3, 5, cubes) + model(1, 1, 1, {{0, 0, 0, 9}}) + graph), expected)
        << rotation.bits;
  }
}

TEST(VoxReader, TurnsWhatIsWithin) {
  // A quarter about z turns the x of the inner translation to y, which is -z of the world.
  const std::string graph = group(0, {1, 4}) +
                            transform(1, 2, {{"_r", std::to_string(0b0010001)}}) +
                            transform(2, 3, {{"_t", "5 0 0"}}) + shape(3, 0) + shape(4, 0);
  EXPECT_EQ(cubes_of(kCube + graph), (Cubes{{0, 0, 0, 1}, {1, 0, 5, 1}}));
}

TEST(VoxReader, SkipsWhatIsHidden) {
  const Attributes hidden = {{"_name", "x"}, {"_hidden", "1"}};
  const std::string shown =
      kCube + model(1, 1, 1, {{0, 0, 0, 2}}) + group(0, {1, 3}) + transform(1, 2, {}) + shape(2, 0);
  const Cubes first = {{0, 0, 0, 1}};
  EXPECT_EQ(cubes_of(shown + transform(3, 4, {}, hidden) + shape(4, 1)), first);
  EXPECT_EQ(cubes_of(shown + group(3, {4}, hidden) + shape(4, 1)), first);
  EXPECT_EQ(cubes_of(shown + shape(3, 1, hidden)), first);
  EXPECT_EQ(cubes_of(shown + transform(3, 4, {}, {}, 7) + shape(4, 1) + layer(7, hidden)), first);
  EXPECT_EQ(cubes_of(shown + transform(3, 4, {}, {{"_hidden", "0"}}, 7) + shape(4, 1) +
                     layer(7, {{"_hidden", "0"}})),
            (Cubes{{0, 0, 0, 2}}));
}

TEST(VoxReader, StandsDeepGraphs) {
  constexpr int kDepth = 100000;
  std::string graph;
  for (int id = 0; id < kDepth; ++id) graph += group(id, {id + 1});
  EXPECT_EQ(cubes_of(kCube + graph + shape(kDepth, 0)).size(), 1u);
}

TEST(VoxReader, TakesTheLargestWorld) {
  const std::string graph = group(0, {1, 3, 5}) + transform(1, 2, {}) + shape(2, 0) +
                            transform(3, 4, {{"_t", "1023 0 0"}}) + shape(4, 0);
  EXPECT_EQ(cubes_of(kCube + graph + transform(5, 6, {{"_t", "0 1023 0"}}) + shape(6, 0)).size(),
            3u);
}

struct BadFile {
  std::string bytes;
  std::string message;
};

std::string cut(const std::string& bytes, std::size_t count) { return bytes.substr(0, count); }

/// Of a scene graph after a model of one cube: its nodes begin at byte 20 + 24 + 20.
BadFile bad_graph(const std::string& graph, const std::string& message) {
  return {file_of(kCube + graph), "w.vox: at byte " + message};
}

std::vector<BadFile> bad_files() {
  const std::string good = file_of(kCube);
  const std::string ends = transform(0, 1, {{"_t", "2147483647 0 0"}});
  const std::string mesh = "# a mesh\nv 0 0 0\nv 1 0 0\n";
  std::vector<BadFile> bad = {
      {"", "w.vox: is empty; use a MagicaVoxel file"},
      {mesh, "w.vox: at byte 0: text, '# a mesh?v 0 0 0'; use a MagicaVoxel file"},
      {"\x1f\x8b\x08\0"s, "w.vox: is compressed with gzip; unpack it with gunzip"},
      {"PK\x03\x04\0"s, "w.vox: is a zip archive; unpack it with unzip"},
      {"glTF\x02\0\0\0"s, "w.vox: at byte 0: 'glTF'; a MagicaVoxel file begins with 'VOX '"},
      {"vox \x96\0\0\0"s, "w.vox: at byte 0: 'vox '; a MagicaVoxel file begins with 'VOX '"},
      {cut(good, 4),
       "w.vox: at byte 0: the header has 8 bytes, but 4 are left; is the file cut off?"},
      {cut(good, 7),
       "w.vox: at byte 0: the header has 8 bytes, but 7 are left; is the file cut off?"},
      {file_of(kCube, 151), "w.vox: at byte 4: version 151; save the file as version 150 or 200"},
      {cut(good, 8), "w.vox: at byte 8: 0 bytes, where a chunk needs 12; is the file cut off?"},
      {cut(good, 19), "w.vox: at byte 8: 11 bytes, where a chunk needs 12; is the file cut off?"},
      {cut(good, 63),
       "w.vox: at byte 20: the part of children of chunk 'MAIN' has 44 bytes, but 43 are left; is "
       "the file cut off?"},
      {"VOX " + number(150) + kCube, "w.vox: at byte 8: chunk 'SIZE'; the first is 'MAIN'"},
      {good + "x", "w.vox: at byte 64: 1 bytes after the last chunk; use a file without"},
      {"VOX " + number(150) + "MAIN" + number(-1) + number(0),
       "w.vox: at byte 20: chunk 'MAIN' has -1 bytes; use 0 or more"},
      {"VOX " + number(150) + "MAIN" + number(0) + number(-9),
       "w.vox: at byte 20: the part of children of chunk 'MAIN' has -9 bytes; use 0 or more"},
      {file_of("SIZE" + number(1000) + number(0) + number(1)),
       "w.vox: at byte 32: chunk 'SIZE' has 1000 bytes, but 4 are left; is the file cut off?"},
      {file_of("S\n\xff"
               "E" +
               number(2147483647) + number(0)),
       "w.vox: at byte 32: chunk 'S??E' has 2147483647 bytes, but 0 are left; is the file cut "
       "off?"},
      {file_of(kCube + "abc"),
       "w.vox: at byte 64: 3 bytes, where a chunk needs 12; is the file cut off?"},
      {file_of(chunk("SIZE", number(1) + number(1))),
       "w.vox: at byte 40: the size of a model has 4 bytes, but 0 are left; is the file cut off?"},
      {file_of(model(1, 0, 1, {})),
       "w.vox: at byte 36: a model of 0 cubes along an axis; use 1 to 256"},
      {file_of(model(1, 1, -5, {})),
       "w.vox: at byte 40: a model of -5 cubes along an axis; use 1 to 256"},
      {file_of(model(257, 1, 1, {})),
       "w.vox: at byte 32: a model of 257 cubes along an axis; use 1 to 256"},
      {file_of(size_chunk(1, 1, 1) + size_chunk(1, 1, 1)),
       "w.vox: at byte 44: a second SIZE; use XYZI after the first"},
      {file_of(kCube + size_chunk(1, 1, 1)),
       "w.vox: at byte 64: a SIZE without cubes; use XYZI after it"},
      {file_of(cubes_chunk({{0, 0, 0, 1}})),
       "w.vox: at byte 20: XYZI without a SIZE; use one before it"},
      {file_of(size_chunk(1, 1, 1) + chunk("XYZI", number(2) + "\0\0\0\1"s)),
       "w.vox: at byte 56: 2 cubes in 4 bytes; use 4 bytes for each"},
      {file_of(size_chunk(1, 1, 1) + chunk("XYZI", number(-1))),
       "w.vox: at byte 56: -1 cubes in 0 bytes; use 4 bytes for each"},
      {file_of(size_chunk(1, 1, 1) + chunk("XYZI", number(0x40000001) + "\0\0\0\1"s)),
       "w.vox: at byte 56: 1073741825 cubes in 4 bytes; use 4 bytes for each"},
      {file_of(model(2, 3, 4, {{1, 2, 3, 1}, {1, 3, 3, 1}})),
       "w.vox: at byte 64: a cube at 3 of axis y; the model has cubes 0 to 2"},
      {file_of(model(2, 3, 4, {{1, 2, 3, 0}})),
       "w.vox: at byte 60: a cube of colour 0; use 1 to 255"},
      {file_of(kCube + chunk("RGBA", std::string(1023, 'a'))),
       "w.vox: at byte 76: the palette has 1024 bytes, but 1023 are left; is the file cut off?"},
      {file_of(""), "w.vox: at byte 8: no cube that is shown; use a file with one"},
      {file_of(model(9, 9, 9, {})), "w.vox: at byte 8: no cube that is shown; use a file with one"},
      bad_graph(shape(1, 0), "8: node 0 is not in the file; use a scene graph that is complete"),
      bad_graph(group(0, {}), "8: no cube that is shown; use a file with one"),
      bad_graph(shape(0, 0, {{"_hidden", "1"}}), "8: no cube that is shown; use a file with one"),
      bad_graph(transform(0, 5, {}),
                "64: node 5 is not in the file; use a scene graph that is complete"),
      bad_graph(group(0, {1, 1}) + shape(1, 0),
                "64: node 1 is reached a second time; use a scene graph that is a tree"),
      bad_graph(transform(0, 0, {}),
                "64: node 0 is reached a second time; use a scene graph that is a tree"),
      bad_graph(group(0, {1}) + group(1, {0}),
                "92: node 0 is reached a second time; use a scene graph that is a tree"),
      bad_graph(group(0, {}) + group(0, {}), "88: a second node 0; use each id once"),
      bad_graph(shape(0, 1), "64: model 1 of a file that has 1; they are counted from 0"),
      bad_graph(shape(0, -1), "64: model -1 of a file that has 1; they are counted from 0"),
      bad_graph(ends + transform(1, 2, {{"_t", "1 0 0"}}) + shape(2, 0),
                "128: a node at 2147483648 of an axis; use places within 2147483647"),
      bad_graph(
          group(0, {1, 2}) + shape(1, 0) + transform(2, 3, {{"_t", "0 0 1024"}}) + shape(3, 0),
          "186: a world of 1025 cubes along an axis; use at most 1024"),
      bad_graph(group(0, {1, 2, 4, 6}) + shape(1, 0) + transform(2, 3, {{"_t", "1023 0 0"}}) +
                    shape(3, 0) + transform(4, 5, {{"_t", "0 1023 0"}}) + shape(5, 0) +
                    transform(6, 7, {{"_t", "0 0 128"}}) + shape(7, 0),
                "373: a world of 1024 x 129 x 1024 cubes; use at most 134217728 in all"),
      bad_graph(chunk("nGRP", number(0) + dictionary({}) + number(9) + number(1)),
                "84: the number of children is 9, but there is room for 1"),
      bad_graph(chunk("nGRP", number(0) + dictionary({}) + number(-3)),
                "84: the number of children is -3; use 0 or more"),
      bad_graph(chunk("nGRP", number(0) + number(2) + number(0) + number(0)),
                "80: the number of attributes is 2, but there is room for 1"),
      bad_graph(chunk("nGRP", number(0) + number(1) + number(-1) + number(0)),
                "88: the name of an attribute has -1 bytes; use 0 or more"),
      bad_graph(chunk("nGRP", number(0) + number(1) + number(0) + number(99)),
                "92: the value of an attribute has 99 bytes, but 0 are left; is the file cut off?"),
  };
  // The value of an attribute that a transform begins its first frame with is at byte 114.
  for (const std::string& value : {""s, "1 2"s, "1 2 3 4"s, "1  2 3"s, "1 2 x"s, "1 2 2147483648"s})
    bad.push_back(bad_graph(transform(0, 1, {{"_t", value}}) + shape(1, 0),
                            "114: '" + value + "' is no translation; use three whole numbers"));
  for (const std::string& value : {""s, "x"s, "-1"s, "128"s, "0"s, "5"s, "3"s, "12"s, "4 "s})
    bad.push_back(bad_graph(
        transform(0, 1, {{"_r", value}}) + shape(1, 0),
        "114: '" + value + "' is no rotation; use bits of two different rows, and of signs"));
  return bad;
}

TEST(VoxReader, RefusesBadFiles) {
  for (const BadFile& bad : bad_files()) {
    SCOPED_TRACE(bad.message);
    try {
      parse_vox("w.vox", bad.bytes);
      ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), bad.message);
    }
  }
}

TEST(VoxReader, RefusesMoreCubesThanAWorldHas) {
  std::vector<FileCube> cubes;
  for (int i = 0; i < 1 << 18; ++i) cubes.push_back({i & 63, i >> 6 & 63, i >> 12, 1});
  std::string graph;
  std::vector<int> children;
  for (int id = 1; id <= 513; ++id) {
    children.push_back(id);
    graph += shape(id, 0);
  }
  try {
    cubes_of(model(64, 64, 64, cubes) + group(0, children) + graph);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("134479872 cubes so far; a world has at most"),
              std::string::npos)
        << error.what();
  }
}

/// With every chunk that the reader takes.
std::string whole_file() {
  std::string palette;
  for (int i = 0; i < 256; ++i) palette += {static_cast<char>(i), 'a', 'b', '\xff'};
  return file_of(chunk("PACK", number(2)) + model(2, 2, 2, {{0, 0, 0, 1}, {1, 1, 1, 2}}) +
                     model(3, 1, 2, {{2, 0, 1, 255}}) + transform(0, 1, {}, {{"_name", "all"}}) +
                     group(1, {2, 4}) + transform(2, 3, {{"_r", "17"}, {"_t", "-3 10 7"}}, {}, 0) +
                     shape(3, 0) + transform(4, 5, {{"_t", "4 0 1"}}, {{"_hidden", "0"}}, 1) +
                     shape(5, 1) + layer(0, {}) + layer(1, {{"_hidden", "0"}}) +
                     chunk("RGBA", palette),
                 200);
}

TEST(VoxReader, RefusesAFileThatIsCutOffAnywhere) {
  const std::string whole = whole_file();
  ASSERT_TRUE(test::probe_vox(whole));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(test::probe_vox(cut(whole, size))) << size;
}

TEST(VoxReader, StandsChangedBytes) {
  std::string bytes = whole_file();
  // Of the palette, which is last, any bytes will do.
  for (std::size_t i = 0; i + 1000 < bytes.size(); ++i) {
    const char right = bytes[i];
    for (const int flips : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      bytes[i] = static_cast<char>(right ^ flips);
      EXPECT_NO_THROW(test::probe_vox(bytes)) << i << ' ' << flips;
    }
    bytes[i] = right;
  }
}

TEST(VoxReader, StandsSeveralChangedBytes) {
  const std::string whole = whole_file();
  for (std::uint64_t round = 0; round < 3000; ++round) {
    std::string bytes = whole;
    for (std::uint64_t change = 0; change < 1 + round % 4; ++change) {
      const std::uint64_t hash = mix64(round * 8 + change);
      bytes[hash % (bytes.size() - 1000)] = static_cast<char>(hash >> 50);
    }
    EXPECT_NO_THROW(test::probe_vox(bytes)) << round;
  }
}

TEST(VoxReader, ReadsFiles) {
  const testing::ScratchDirectory scratch;
  const std::string path = scratch / "w.vox";
  std::ofstream(path, std::ios::binary) << file_of(kCube);
  EXPECT_EQ(read_vox(path).filled_count(), 1u);
}

std::string refusal(const std::string& path) {
  try {
    read_vox(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(VoxReader, RefusesWhatIsNoFile) {
  const testing::ScratchDirectory scratch;
  const std::string folder = scratch.path();
  EXPECT_EQ(refusal(folder), folder + ": is a folder; use a MagicaVoxel file");
  const std::string missing = scratch / "missing.vox";
  EXPECT_EQ(refusal(missing), missing + ": cannot be opened: No such file or directory");
}

}  // namespace
}  // namespace lanescope
