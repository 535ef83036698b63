// SPDX-License-Identifier: MIT
#include "workloads/voxels/vox_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "simulator/base/error.h"
#include "workloads/geometry/file_signature.h"
#include "workloads/geometry/obj_words.h"
#include "workloads/geometry/whole_file.h"
#include "workloads/voxels/vox_chunks.h"

namespace lanescope {
namespace {

using namespace vox;

constexpr std::size_t kHeaderBytes = 8;
constexpr std::int64_t kMostModelCubes = 256;  // Along an axis: places of cubes are bytes.
constexpr std::int64_t kFarthest = std::numeric_limits<std::int32_t>::max();

using Int3 = std::array<std::int64_t, 3>;

/// Turns about the origin by quarters, perhaps mirrors, and then moves. Axes are those of the file.
struct Placement {
  std::array<std::size_t, 3> from{0, 1, 2};  ///< The axis that becomes the first, ...
  std::array<int, 3> sign{1, 1, 1};
  Int3 shift{};

  Int3 turned(const Int3& p) const {
    return {sign[0] * p[from[0]], sign[1] * p[from[1]], sign[2] * p[from[2]]};
  }
  /// Of a cube, by its corner that is nearest to the origin before and after.
  Int3 placed(const Int3& cube) const {
    // Twice the middle is odd, whatever the turn, so that halves are exact.
    const Int3 middle = turned({2 * cube[0] + 1, 2 * cube[1] + 1, 2 * cube[2] + 1});
    return {(middle[0] - 1) / 2 + shift[0], (middle[1] - 1) / 2 + shift[1],
            (middle[2] - 1) / 2 + shift[2]};
  }
};

/// `inner` first.
Placement joined(const Placement& outer, const Placement& inner) {
  Placement both;
  const Int3 shift = outer.turned(inner.shift);
  for (std::size_t i = 0; i < 3; ++i) {
    both.from[i] = inner.from[outer.from[i]];
    both.sign[i] = outer.sign[i] * inner.sign[outer.from[i]];
    both.shift[i] = shift[i] + outer.shift[i];
  }
  return both;
}

/// The whole of a word as a number of 32 bits.
std::optional<std::int64_t> whole_number(std::string_view word) {
  std::int32_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || stop != end) return {};
  return value;
}

/// `x y z`.
Int3 shift_of(const Entry& entry) {
  Int3 shift{};
  std::string_view rest = entry.value;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t blank = i < 2 ? rest.find(' ') : rest.size();
    const auto value = whole_number(rest.substr(0, blank));
    if (!value || blank == rest.npos)
      entry.place.fail("'{}' is no translation; use three whole numbers", shown(entry.value));
    shift[i] = *value;
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  return shift;
}

/// Two bits for the axis that each of the first two rows takes, then three for signs.
void set_rotation(Placement& placement, const Entry& entry) {
  const std::int64_t bits = whole_number(entry.value).value_or(-1);
  const auto first = static_cast<std::size_t>(bits & 3),
             second = static_cast<std::size_t>(bits >> 2 & 3);
  if (bits < 0 || bits > 127 || first > 2 || second > 2 || first == second)
    entry.place.fail("'{}' is no rotation; use bits of two different rows, and of signs",
                     shown(entry.value));
  placement.from = {first, second, 3 - first - second};
  for (std::size_t i = 0; i < 3; ++i) placement.sign[i] = (bits >> (4 + i) & 1) != 0 ? -1 : 1;
}

struct Model {
  Int3 size;
  std::string_view cubes;  ///< x, y, z and a colour of each.
  Int3 low{kMostModelCubes, kMostModelCubes, kMostModelCubes}, high{-1, -1, -1};  ///< Of cubes.

  std::size_t count() const { return cubes.size() / 4; }
  Int3 cube(std::size_t i) const { return {byte(4 * i), byte(4 * i + 1), byte(4 * i + 2)}; }
  std::uint8_t colour(std::size_t i) const { return byte(4 * i + 3); }
  std::uint8_t byte(std::size_t i) const { return static_cast<std::uint8_t>(cubes[i]); }
};

struct Node {
  Place place;
  bool is_hidden = false;
  std::int64_t layer = -1;
  Placement placement{};
  std::vector<std::int64_t> children{};
  std::optional<std::int64_t> model{};
};

struct PlacedModel {
  const Model* model;
  Placement placement;
};

bool is_hidden(const std::vector<Entry>& attributes) {
  return std::any_of(attributes.begin(), attributes.end(), [](const Entry& entry) {
    return entry.key == "_hidden" && entry.value == "1";
  });
}

/// The palette of files that have none: red, green and blue in six steps each, blue the fastest,
/// down from white and without black; then ten shades each of red, green, blue and grey.
void set_default_palette(World& world) {
  std::size_t number = 1;
  for (int i = 0; i < 215; ++i) {
    const auto step = [](int n) { return static_cast<std::uint8_t>(255 - 51 * n); };
    world.palette[number++] = {step(i / 36), step(i / 6 % 6), step(i % 6)};
  }
  constexpr std::uint8_t kShades[] = {0xee, 0xdd, 0xbb, 0xaa, 0x88, 0x77, 0x55, 0x44, 0x22, 0x11};
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (const std::uint8_t shade : kShades) world.palette[number++][channel] = shade;
  for (const std::uint8_t shade : kShades) world.palette[number++] = {shade, shade, shade};
}

/// A turn about x that has z, which is up in the file, point along y. Not a mirror: what went away
/// from the viewer along y comes towards him along -z.
Int3 upright(const Int3& cube) { return {cube[0], cube[2], -1 - cube[1]}; }

/// A box of cubes, grown by those of models.
struct Extent {
  Int3 low{kFarthest, kFarthest, kFarthest}, high{-kFarthest, -kFarthest, -kFarthest};

  void add(const Int3& cube) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], cube[i]);
      high[i] = std::max(high[i], cube[i]);
    }
  }
  std::int64_t size(std::size_t i) const { return high[i] - low[i] + 1; }
};

class Reader {
 public:
  Reader(std::string_view file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  World read() {
    Bytes bytes(file_, bytes_, 0);
    check_header(bytes);
    const Chunk main = next_chunk(bytes);
    if (main.name != "MAIN") main.place.fail("chunk '{}'; the first is 'MAIN'", shown(main.name));
    if (bytes.left() > 0)
      bytes.place().fail("{} bytes after the last chunk; use a file without", bytes.left());
    for (Bytes children = main.children; children.left() > 0;) take(next_chunk(children));
    if (size_) size_place_.fail("a SIZE without cubes; use XYZI after it");
    place_models(main.place);
    return world();
  }

 private:
  static void check_header(Bytes& bytes) {
    const Bytes header = bytes.take(kHeaderBytes, "the header");
    Bytes version(header);
    version.take(4, "the header");
    const Place place = version.place();
    const std::int64_t number = version.number("the version");
    if (number != 150 && number != 200)
      place.fail("version {}; save the file as version 150 or 200", number);
  }

  /// Others are materials, cameras, settings and such.
  void take(Chunk chunk) {
    if (chunk.name == "SIZE") return take_size(chunk);
    if (chunk.name == "XYZI") return take_cubes(chunk);
    if (chunk.name == "RGBA") return take_palette(chunk);
    if (chunk.name == "LAYR") return take_layer(chunk);
    if (chunk.name == "nTRN") return take_transform(chunk);
    if (chunk.name == "nGRP") return take_group(chunk);
    if (chunk.name == "nSHP") return take_shape(chunk);
  }

  void take_size(Chunk& chunk) {
    if (size_) chunk.place.fail("a second SIZE; use XYZI after the first");
    size_place_ = chunk.place;
    size_.emplace();
    for (std::int64_t& cubes : *size_) {
      const Place place = chunk.content.place();
      cubes = chunk.content.number("the size of a model");
      if (cubes < 1 || cubes > kMostModelCubes)
        place.fail("a model of {} cubes along an axis; use 1 to {}", cubes, kMostModelCubes);
    }
  }

  void take_cubes(Chunk& chunk) {
    if (!size_) chunk.place.fail("XYZI without a SIZE; use one before it");
    const Place place = chunk.content.place();
    const std::int64_t count = chunk.content.number("the number of cubes");
    if (count < 0 || static_cast<std::uint64_t>(count) * 4 != chunk.content.left())
      place.fail("{} cubes in {} bytes; use 4 bytes for each", count, chunk.content.left());
    Model& model = models_.emplace_back(Model{.size = *size_, .cubes = chunk.content.text()});
    size_.reset();
    while (chunk.content.left() > 0) check_cube(model, chunk.content);
  }

  static void check_cube(Model& model, Bytes& content) {
    const Place place = content.place();
    const std::string_view bytes = content.take(4, "a cube").text();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t at = static_cast<std::uint8_t>(bytes[i]);
      if (at >= model.size[i])
        place.fail("a cube at {} of axis {}; the model has cubes 0 to {}", at, "xyz"[i],
                   model.size[i] - 1);
      model.low[i] = std::min(model.low[i], at);
      model.high[i] = std::max(model.high[i], at);
    }
    if (bytes[3] == 0) place.fail("a cube of colour 0; use 1 to 255");
  }

  void take_palette(Chunk& chunk) { palette_ = chunk.content.take(4 * 256, "the palette").text(); }

  void take_layer(Chunk& chunk) {
    const std::int64_t id = chunk.content.number("the id of a layer");
    layers_hidden_[id] = is_hidden(chunk.content.dictionary());
  }

  /// What all nodes begin with.
  Node& new_node(Chunk& chunk) {
    const std::int64_t id = chunk.content.number("the id of a node");
    const auto [place, is_new] = nodes_.try_emplace(id, Node{.place = chunk.place});
    if (!is_new) chunk.place.fail("a second node {}; use each id once", id);
    place->second.is_hidden = is_hidden(chunk.content.dictionary());
    return place->second;
  }

  void take_transform(Chunk& chunk) {
    Node& node = new_node(chunk);
    node.children.push_back(chunk.content.number("the id of a child"));
    chunk.content.number("what is reserved");
    node.layer = chunk.content.number("the id of a layer");
    if (chunk.content.count("the number of frames", 4) == 0) return;
    // Of an animation, the first frame is shown.
    for (const Entry& entry : chunk.content.dictionary()) {
      if (entry.key == "_t") node.placement.shift = shift_of(entry);
      if (entry.key == "_r") set_rotation(node.placement, entry);
    }
  }

  void take_group(Chunk& chunk) {
    Node& node = new_node(chunk);
    const std::int64_t count = chunk.content.count("the number of children", 4);
    for (std::int64_t i = 0; i < count; ++i)
      node.children.push_back(chunk.content.number("the id of a child"));
  }

  void take_shape(Chunk& chunk) {
    Node& node = new_node(chunk);
    if (chunk.content.count("the number of models", 8) > 0)
      node.model = chunk.content.number("the id of a model");  // The first, as of transforms.
  }

  void place_models(const Place& main) {
    if (nodes_.empty()) {
      for (const Model& model : models_) {
        Placement corner;
        corner.shift = pivot(model);
        place_model(model, corner, main);
      }
    } else {
      walk(main);
    }
    if (placed_.empty()) main.fail("no cube that is shown; use a file with one");
  }

  struct Step {
    const Node* node;
    Placement placement;  ///< Of what the node is in.
  };

  /// Places what the node 0 and those below it show, in the order of the file. A stack of its own
  /// stands any depth.
  void walk(const Place& main) {
    std::vector<Step> steps{{&reached(0, main), {}}};
    while (!steps.empty()) {
      const Step step = steps.back();
      steps.pop_back();
      if (is_unseen(*step.node)) continue;
      const Placement placement = joined(step.placement, step.node->placement);
      for (const std::int64_t along : placement.shift)
        if (std::abs(along) > kFarthest)
          step.node->place.fail("a node at {} of an axis; use places within {}", along, kFarthest);
      if (step.node->model) place_model(model_of(*step.node), placement, step.node->place);
      const std::size_t first = steps.size();
      for (const std::int64_t id : step.node->children)
        steps.push_back({&reached(id, step.node->place), placement});
      std::reverse(steps.begin() + static_cast<std::ptrdiff_t>(first), steps.end());
    }
  }

  bool is_unseen(const Node& node) const {
    const auto layer = layers_hidden_.find(node.layer);
    return node.is_hidden || (layer != layers_hidden_.end() && layer->second);
  }

  /// A node that a node has as its child, or the first. In a tree each is reached once.
  const Node& reached(std::int64_t id, const Place& from) {
    const auto found = nodes_.find(id);
    if (found == nodes_.end())
      from.fail("node {} is not in the file; use a scene graph that is complete", id);
    if (!reached_.emplace(id, true).second)
      from.fail("node {} is reached a second time; use a scene graph that is a tree", id);
    return found->second;
  }

  const Model& model_of(const Node& node) const {
    if (*node.model < 0 || static_cast<std::uint64_t>(*node.model) >= models_.size())
      node.place.fail("model {} of a file that has {}; they are counted from 0", *node.model,
                      models_.size());
    return models_[static_cast<std::size_t>(*node.model)];
  }

  /// A model turns about this corner of it.
  static Int3 pivot(const Model& model) {
    return {model.size[0] / 2, model.size[1] / 2, model.size[2] / 2};
  }

  void place_model(const Model& model, const Placement& placement, const Place& place) {
    if (model.count() == 0) return;
    Placement about_pivot;
    for (std::size_t i = 0; i < 3; ++i) about_pivot.shift[i] = -pivot(model)[i];
    placed_.push_back({&model, joined(placement, about_pivot)});
    for (const Int3& corner : {model.low, model.high})
      extent_.add(upright(placed_.back().placement.placed(corner)));
    check_extent(place);
    cubes_ += model.count();
    if (cubes_ > World::kMostVolume)
      place.fail("{} cubes so far; a world has at most {}", cubes_, World::kMostVolume);
  }

  void check_extent(const Place& place) const {
    std::int64_t volume = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if (extent_.size(i) > World::kMostCubes)
        place.fail("a world of {} cubes along an axis; use at most {}", extent_.size(i),
                   World::kMostCubes);
      volume *= extent_.size(i);
    }
    if (static_cast<std::uint64_t>(volume) > World::kMostVolume)
      place.fail("a world of {} x {} x {} cubes; use at most {} in all", extent_.size(0),
                 extent_.size(1), extent_.size(2), World::kMostVolume);
  }

  World world() const {
    const auto length = [this](std::size_t i) { return static_cast<int>(extent_.size(i)); };
    World world({length(0), length(1), length(2)});
    set_palette(world);
    const auto from_low = [this](const Int3& cube, std::size_t i) {
      return static_cast<int>(cube[i] - extent_.low[i]);
    };
    for (const PlacedModel& placed : placed_)
      for (std::size_t i = 0; i < placed.model->count(); ++i) {
        const Int3 cube = upright(placed.placement.placed(placed.model->cube(i)));
        world.fill({from_low(cube, 0), from_low(cube, 1), from_low(cube, 2)},
                   placed.model->colour(i));
      }
    return world;
  }

  /// Number i is the entry i - 1 of the file; the last entry is of no use.
  void set_palette(World& world) const {
    if (palette_.empty()) return set_default_palette(world);
    for (std::size_t number = 1; number < world.palette.size(); ++number)
      for (std::size_t channel = 0; channel < 3; ++channel)
        world.palette[number][channel] =
            static_cast<std::uint8_t>(palette_[4 * (number - 1) + channel]);
  }

  std::string_view file_, bytes_;
  std::optional<Int3> size_;  ///< Of a model whose cubes are to come.
  Place size_place_{file_, 0};
  std::vector<Model> models_;
  std::string_view palette_;
  std::unordered_map<std::int64_t, Node> nodes_;
  std::unordered_map<std::int64_t, bool> layers_hidden_, reached_;
  std::vector<PlacedModel> placed_;
  Extent extent_;
  std::uint64_t cubes_ = 0;
};

/// Files that have another beginning, which may tell what they are.
[[noreturn]] void refuse(const std::string& name, std::string_view bytes) {
  if (bytes.empty()) throw InputError(name, "is empty; use a MagicaVoxel file");
  const std::string_view kind = unreadable_kind(bytes);
  // What it says of other files is how to make a mesh of them.
  if (kind.find("unpack it") != kind.npos || kind.find("fetch the file") != kind.npos)
    throw InputError(name, "{}", kind);
  const Place place(name, 0);
  if (kind.empty()) place.fail("text, '{}'; use a MagicaVoxel file", shown(bytes.substr(0, 16)));
  place.fail("'{}'; a MagicaVoxel file begins with 'VOX '", shown(bytes.substr(0, 4)));
}

}  // namespace

World parse_vox(const std::string& name, std::string_view bytes) {
  if (!bytes.starts_with("VOX ")) refuse(name, bytes);
  return Reader(name, bytes).read();
}

World read_vox(const std::string& file) {
  return parse_vox(file, whole_file(file, "a MagicaVoxel file"));
}

}  // namespace lanescope
