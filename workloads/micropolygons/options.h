// SPDX-License-Identifier: MIT
// What a scene of micropolygons is made with.
#pragma once

#include <optional>

#include "simulator/base/parameter.h"
#include "workloads/geometry/mesh.h"
#include "workloads/micropolygons/grid.h"
#include "workloads/micropolygons/micropolygon.h"
#include "workloads/micropolygons/sample_grid.h"

namespace lanescope {

struct TessellationOptions {
  Micropolygon shape = Micropolygon::kTriangle;
  int width_px = 1728;
  int height_px = 1080;
  int samples_per_pixel = 4;
  float dice_area_px = 1.0f;
  int grid_limit = 16;
  int packet_capacity = 2880;
  float grid_overlap_px = kGridOverlapPx;
};

inline const Parameters<TessellationOptions>& tessellation_parameters() {
  using T = TessellationOptions;
  static const Parameters<T> all{
      {&T::shape,
       {"micropolygon", "--micropolygon", kNoUnit, "Shape of the micropolygons"},
       kShapes},
      {&T::width_px,
       {"width_px", "--resolution", "px", "Width of the frame", Stated::kAlways},
       1,
       SampleGrid::kMaxCells},
      {&T::height_px,
       {"height_px", "--resolution", "px", "Height of the frame", Stated::kAlways},
       1,
       SampleGrid::kMaxCells},
      {&T::samples_per_pixel,
       {"samples_per_pixel", "--msaa", "samples/px", "Samples a pixel", Stated::kAlways},
       std::span<const int>(SampleGrid::kSampleCounts)},
      {&T::dice_area_px,
       {"dice_area_px", "--dice-area", "px", "Target area of a quad; a triangle has half of it"},
       0.01f,
       10000.0f},
      {&T::grid_limit, {"grid_limit", "--grid", "quads", "A grid has at most N x N quads"}, 1, 128},
      {&T::packet_capacity,
       {"packet_capacity", "--drain", "micropolygons", "Kernels drain after N micropolygons"},
       1,
       1 << 20},
      {&T::grid_overlap_px,
       {"grid_overlap_px", "--grid-overlap", "px",
        "Outer vertices of a grid are moved outward, so that neighbours leave no cracks"},
       0.0f,
       1.0f},
  };
  return all;
}

/// What is seen; members without a value are as the scene has them.
struct SceneOptions {
  std::optional<int> frame;            ///< Of a built-in scene.
  std::optional<MeshPatches> patches;  ///< Of a mesh.
  float turn_degrees = 0.0f;
};

inline const Parameters<SceneOptions>& scene_parameters() {
  using S = SceneOptions;
  static const Parameters<S> all{
      {&S::frame, {"frame", "--frame", kNoUnit, "Frame of the animation, from 0"}, 0, 1 << 20},
      {&S::patches,
       {"mesh_patches", "--patches", kNoUnit, "Patches that the faces of a mesh become"},
       kMeshPatches},
      {&S::turn_degrees,
       {"turn_degrees", "--turn", "degrees", "Turns the picture about the view axis"},
       -360.0f,
       360.0f},
  };
  return all;
}

}  // namespace lanescope
