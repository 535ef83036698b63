// SPDX-License-Identifier: MIT
// What a world of cubes is made with, and what its probes look for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "simulator/base/parameter.h"
#include "workloads/voxels/brick.h"

namespace lanescope {

/// Where the samples of an octant are.
enum class SkyProjection {
  kFaces,  ///< The pixels of three faces of 16 x 16, a quarter of a cubemap's each.
  /// 256 directions, 64 for each of four harmonics, as dense as that harmonic is large: then the
  /// harmonic is the number of samples that see the sky.
  kDirections,
};

inline constexpr std::array<Choice<SkyProjection>, 2> kProjections{
    {{"faces", SkyProjection::kFaces}, {"directions", SkyProjection::kDirections}}};

/// The share of its cubes that makes a megacube opaque, if none is given.
inline constexpr float kMegaFill = 0.25f;

struct WorldOptions {
  SkyProjection projection = SkyProjection::kFaces;
  std::optional<int> size_cubes;      ///< Of a built-in scene.
  std::optional<std::uint64_t> seed;  ///< Of a built-in scene.
  int piece_probes = 256;
  int levels = 1;
  std::optional<float> mega_fill;  ///< With two levels.
};

inline const Parameters<WorldOptions>& world_parameters() {
  using W = WorldOptions;
  static const Parameters<W> all{
      {&W::projection,
       {"projection", "--projection", kNoUnit, "Where the samples of an octant are"},
       kProjections},
      {&W::size_cubes,
       {"world_size", "--world-size", "cubes", "Length and width of a built-in world",
        Stated::kAlways},
       16,
       256},
      {&W::seed,
       {"world_seed", "--world-seed", kNoUnit, "Seed of a built-in world"},
       std::uint64_t{0},
       ~std::uint64_t{0}},
      {&W::piece_probes,
       {"piece_probes", "--piece-probes", "probes", "Kernels drain after N probes of a brick"},
       1,
       kMostProbes},
      {&W::levels,
       {"levels", "--levels", kNoUnit,
        "What probes see: 16 cubes each way (1), and 16 megacubes of 4 x 4 x 4 cubes (2)"},
       1,
       2},
      {&W::mega_fill,
       {"mega_fill", "--mega-fill", "cubes / cubes",
        "A megacube is opaque if this share of its cubes is filled"},
       0.0f,
       1.0f},
  };
  return all;
}

}  // namespace lanescope
