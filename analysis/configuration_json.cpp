// SPDX-License-Identifier: MIT
#include "analysis/configuration_json.h"

#include <cmath>
#include <limits>

#include "analysis/json_text.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxWidth = 64;

template <class Value, std::size_t kCount>
Value read_choice(const JsonCursor& cursor, const std::array<Choice<Value>, kCount>& choices) {
  const auto value = find_choice(choices, cursor.string());
  if (!value) cursor.fail(list_or(choices));
  return *value;
}

float read_float(const JsonCursor& cursor) {
  const double number = cursor.number();
  if (std::abs(number) > std::numeric_limits<float>::max())
    cursor.fail("a number in the range of single precision");
  return static_cast<float>(number);
}

}  // namespace

Json configuration_json(const Configuration& c) {
  return {
      {"kernel", c.kernel},
      {"width_lanes", c.width},
      {"micropolygon", name_of(kShapes, c.shape())},
      {"scene", c.scene},
      {"mesh_patches", c.is_mesh() ? Json(name_of(kMeshPatches, *c.mesh_patches)) : Json(nullptr)},
      {"frame", c.frame},
      {"turn_degrees", json_number(c.turn_degrees)},
      {"mode", name_of(kModes, c.mode)},
      {"cull_backfaces", c.options.cull_backfaces},
      {"edges", name_of(kEdges, c.options.edges)},
      {"stream_load_threshold", json_number(c.options.stream_load_threshold)},
      {"width_px", c.tessellation.width_px},
      {"height_px", c.tessellation.height_px},
      {"samples_per_pixel", c.samples_per_pixel},
      {"jitter", c.jitter},
      {"seed", c.seed},
      {"dice_area_px", json_number(c.tessellation.dice_area_px)},
      {"grid_limit", c.tessellation.grid_limit},
      {"packet_capacity", c.tessellation.packet_capacity},
      {"grid_overlap_px", json_number(c.tessellation.grid_overlap_px)},
      {"observe_every", c.observe_every}};
}

Configuration read_configuration(const JsonCursor& cursor) {
  cursor.require_members({"kernel", "width_lanes", "micropolygon", "scene", "mesh_patches", "frame",
                          "turn_degrees", "mode", "cull_backfaces", "edges",
                          "stream_load_threshold", "width_px", "height_px", "samples_per_pixel",
                          "jitter", "seed", "dice_area_px", "grid_limit", "packet_capacity",
                          "grid_overlap_px", "observe_every"});
  Configuration c;
  c.kernel = cursor.member("kernel").string();
  c.width = cursor.member("width_lanes").integer(1, kMaxWidth);
  c.options.shape = read_choice(cursor.member("micropolygon"), kShapes);
  c.scene = cursor.member("scene").string();
  const JsonCursor patches = cursor.member("mesh_patches");
  if (!patches.is_null()) c.mesh_patches = read_choice(patches, kMeshPatches);
  c.frame = cursor.member("frame").integer(0);
  c.turn_degrees = read_float(cursor.member("turn_degrees"));
  c.mode = read_choice(cursor.member("mode"), kModes);
  c.options.cull_backfaces = cursor.member("cull_backfaces").boolean();
  c.options.edges = read_choice(cursor.member("edges"), kEdges);
  c.options.stream_load_threshold = read_float(cursor.member("stream_load_threshold"));
  c.tessellation.width_px = cursor.member("width_px").integer(1);
  c.tessellation.height_px = cursor.member("height_px").integer(1);
  c.samples_per_pixel = cursor.member("samples_per_pixel").integer(1);
  c.jitter = cursor.member("jitter").boolean();
  c.seed = cursor.member("seed").count();
  c.tessellation.dice_area_px = read_float(cursor.member("dice_area_px"));
  c.tessellation.grid_limit = cursor.member("grid_limit").integer(1);
  c.tessellation.packet_capacity = cursor.member("packet_capacity").integer(1);
  c.tessellation.grid_overlap_px = read_float(cursor.member("grid_overlap_px"));
  c.observe_every = cursor.member("observe_every").integer(0);
  return c;
}

}  // namespace lanescope
