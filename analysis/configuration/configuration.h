// SPDX-License-Identifier: MIT
// One configuration of an experiment, with every parameter resolved, and the names that options and
// reports use for its choices.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/kernel.h"
#include "workloads/geometry/mesh.h"
#include "workloads/micropolygons/sample_grid.h"
#include "workloads/micropolygons/tessellator.h"

namespace lanescope {

/// A kernel at one width on one scene: all that decides what a run counts.
struct Configuration {
  std::string kernel = "lockstep";
  int width = 16;
  Mode mode = Mode::kCounting;
  KernelOptions options;
  /// The name of a built-in scene, or the path of a mesh file.
  std::string scene;
  /// How the faces of a mesh become patches; none for a built-in scene.
  std::optional<MeshPatches> mesh_patches;
  int frame = 0;
  float turn_degrees = 0.0f;  ///< Turns the picture about the view axis.
  /// Without what the kernel and the sampling decide; see tessellation_options.
  TessellationOptions tessellation;
  int samples_per_pixel = 4;
  bool jitter = true;
  std::uint64_t seed = 1;  ///< Of the jitter.
  /// Memory and source lines are observed in every so many packets; 0 in none, 1 in all.
  int observe_every = 16;

  Micropolygon shape() const { return options.shape; }
  bool is_mesh() const { return mesh_patches.has_value(); }
  SampleGrid sample_grid() const;
  /// `tessellation`, with the shape that the kernel expects and the cells of the sample grid.
  TessellationOptions tessellation_options() const;
};

/// Whether the packets of two configurations are the same, so that one tessellation feeds both.
bool same_tessellation(const Configuration& a, const Configuration& b);

/// A choice and the word for it on the command line and in reports.
template <class Value>
struct Choice {
  std::string_view name;
  Value value;
};

inline constexpr std::array<Choice<Mode>, 3> kModes{
    {{"counting", Mode::kCounting}, {"checked", Mode::kChecked}, {"uncounted", Mode::kUncounted}}};
inline constexpr std::array<Choice<Edges>, 2> kEdges{
    {{"inline", Edges::kInline}, {"precomputed", Edges::kPrecomputed}}};
inline constexpr std::array<Choice<Micropolygon>, 2> kShapes{
    {{"triangle", Micropolygon::kTriangle}, {"quad", Micropolygon::kQuad}}};
inline constexpr std::array<Choice<MeshPatches>, 3> kMeshPatches{
    {{"linear", MeshPatches::kLinear}, {"pn", MeshPatches::kPn}, {"phong", MeshPatches::kPhong}}};
inline constexpr std::array<Choice<bool>, 2> kSwitch{{{"on", true}, {"off", false}}};

/// The word for `value`. Requires that it is among the choices.
template <class Value, std::size_t kCount>
std::string_view name_of(const std::array<Choice<Value>, kCount>& choices, Value value) {
  for (const Choice<Value>& choice : choices)
    if (choice.value == value) return choice.name;
  return {};
}

/// The choice of that name, if there is one.
template <class Value, std::size_t kCount>
std::optional<Value> find_choice(const std::array<Choice<Value>, kCount>& choices,
                                 std::string_view name) {
  for (const Choice<Value>& choice : choices)
    if (choice.name == name) return choice.value;
  return std::nullopt;
}

/// The names of descriptors: of kernels(), scenes(), tables().
template <class Descriptor>
std::vector<std::string> names_of(const std::vector<const Descriptor*>& descriptors) {
  std::vector<std::string> names;
  for (const Descriptor* descriptor : descriptors) names.emplace_back(descriptor->name);
  return names;
}

/// The names of choices as a sentence lists them: `on or off`, `1, 4 or 9`.
std::string list_or(std::span<const std::string> names);

template <class Value, std::size_t kCount>
std::string list_or(const std::array<Choice<Value>, kCount>& choices) {
  std::array<std::string, kCount> names;
  for (std::size_t i = 0; i < kCount; ++i) names[i] = choices[i].name;
  return list_or(std::span<const std::string>(names));
}

}  // namespace lanescope
