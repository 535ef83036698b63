// SPDX-License-Identifier: MIT
#include "analysis/configuration/configuration_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "analysis/base/json_text.h"
#include "simulator/base/error.h"

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

using Source = const JsonCursor&;
using From = const Configuration&;
using Into = Configuration&;

/// A parameter: its name, how it is written, and how it is read.
struct Parameter {
  std::string_view name;
  Json (*write)(From c);
  void (*read)(Source value, Into c);
};

/// In the order of the JSON form.
constexpr Parameter kParameters[] = {
    {"kernel", [](From c) { return Json(c.kernel); },
     [](Source value, Into c) { c.kernel = value.string(); }},
    {"width_lanes", [](From c) { return Json(c.width); },
     [](Source value, Into c) { c.width = value.integer(1, kMaxWidth); }},
    {"micropolygon", [](From c) { return Json(name_of(kShapes, c.shape())); },
     [](Source value, Into c) { c.options.shape = read_choice(value, kShapes); }},
    {"scene", [](From c) { return Json(c.scene); },
     [](Source value, Into c) { c.scene = value.string(); }},
    {"mesh_patches",
     [](From c) { return c.is_mesh() ? Json(name_of(kMeshPatches, *c.mesh_patches)) : Json(); },
     [](Source value, Into c) {
       c.mesh_patches.reset();
       if (!value.is_null()) c.mesh_patches = read_choice(value, kMeshPatches);
     }},
    {"frame", [](From c) { return Json(c.frame); },
     [](Source value, Into c) { c.frame = value.integer(0); }},
    {"turn_degrees", [](From c) { return Json(json_number(c.turn_degrees)); },
     [](Source value, Into c) { c.turn_degrees = read_float(value); }},
    {"mode", [](From c) { return Json(name_of(kModes, c.mode)); },
     [](Source value, Into c) { c.mode = read_choice(value, kModes); }},
    {"cull_backfaces", [](From c) { return Json(c.options.cull_backfaces); },
     [](Source value, Into c) { c.options.cull_backfaces = value.boolean(); }},
    {"edges", [](From c) { return Json(name_of(kEdges, c.options.edges)); },
     [](Source value, Into c) { c.options.edges = read_choice(value, kEdges); }},
    {"stream_load_threshold",
     [](From c) { return Json(json_number(c.options.stream_load_threshold)); },
     [](Source value, Into c) { c.options.stream_load_threshold = read_float(value); }},
    {"width_px", [](From c) { return Json(c.tessellation.width_px); },
     [](Source value, Into c) { c.tessellation.width_px = value.integer(1); }},
    {"height_px", [](From c) { return Json(c.tessellation.height_px); },
     [](Source value, Into c) { c.tessellation.height_px = value.integer(1); }},
    {"samples_per_pixel", [](From c) { return Json(c.samples_per_pixel); },
     [](Source value, Into c) { c.samples_per_pixel = value.integer(1); }},
    {"jitter", [](From c) { return Json(c.jitter); },
     [](Source value, Into c) { c.jitter = value.boolean(); }},
    {"seed", [](From c) { return Json(c.seed); },
     [](Source value, Into c) { c.seed = value.count(); }},
    {"dice_area_px", [](From c) { return Json(json_number(c.tessellation.dice_area_px)); },
     [](Source value, Into c) { c.tessellation.dice_area_px = read_float(value); }},
    {"grid_limit", [](From c) { return Json(c.tessellation.grid_limit); },
     [](Source value, Into c) { c.tessellation.grid_limit = value.integer(1); }},
    {"packet_capacity", [](From c) { return Json(c.tessellation.packet_capacity); },
     [](Source value, Into c) { c.tessellation.packet_capacity = value.integer(1); }},
    {"grid_overlap_px", [](From c) { return Json(json_number(c.tessellation.grid_overlap_px)); },
     [](Source value, Into c) { c.tessellation.grid_overlap_px = read_float(value); }},
    {"observe_every", [](From c) { return Json(c.observe_every); },
     [](Source value, Into c) { c.observe_every = value.integer(0); }},
};

const Parameter& find_parameter(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kParameters), std::end(kParameters),
                                         [&](const Parameter& p) { return p.name == name; });
  LANESCOPE_CHECK(found != std::end(kParameters), "{} is not a parameter", name);
  return *found;
}

}  // namespace

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const Parameter& parameter : kParameters) names.emplace_back(parameter.name);
  return names;
}

Json parameter_json(std::string_view name, const Configuration& configuration) {
  return find_parameter(name).write(configuration);
}

void read_parameter(std::string_view name, const JsonCursor& value, Configuration& configuration) {
  find_parameter(name).read(value, configuration);
}

Json configuration_json(const Configuration& configuration) {
  Json json = Json::object();
  for (const Parameter& parameter : kParameters)
    json[std::string(parameter.name)] = parameter.write(configuration);
  return json;
}

Configuration read_configuration(const JsonCursor& cursor) {
  cursor.require_members(parameter_names());
  Configuration c;
  for (const Parameter& parameter : kParameters) parameter.read(cursor.member(parameter.name), c);
  return c;
}

}  // namespace lanescope
