// SPDX-License-Identifier: MIT
// What the rasterizers of micropolygons are started with.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/base/parameter.h"
#include "workloads/micropolygons/micropolygon.h"
#include "workloads/micropolygons/sample_grid.h"

namespace lanescope {

/// When the edge equations of a micropolygon are computed (the thesis, 3.2.1, "optional").
enum class Edges {
  kInline,       ///< In each Test, from the vertices.
  kPrecomputed,  ///< Once, in Bound.
};

inline constexpr std::array<Choice<Edges>, 2> kEdges{
    {{"inline", Edges::kInline}, {"precomputed", Edges::kPrecomputed}}};

/// Where samples are in their cells.
struct SamplingOptions {
  bool jitter = true;
  std::uint64_t seed = 1;
};

inline const Parameters<SamplingOptions>& sampling_parameters() {
  using S = SamplingOptions;
  static const Parameters<S> all{
      {&S::jitter, {"jitter", "--jitter", kNoUnit, "Samples at random places of their cells"}},
      {&S::seed,
       {"seed", "--seed", kNoUnit, "Seed of the jitter"},
       std::uint64_t{0},
       ~std::uint64_t{0}},
  };
  return all;
}

struct KernelOptions {
  bool cull_backfaces = true;
  Edges edges = Edges::kInline;
  /// REPACK loads new work into free lanes only when at least this share of the W lanes is free,
  /// or none is busy (the thesis, 4.1.2). 0 loads whenever a lane is free.
  float stream_load_threshold = 0.0f;
};

/// Those that every rasterizer takes.
inline const Parameters<KernelOptions>& raster_parameters() {
  using K = KernelOptions;
  static const Parameters<K> all{
      {&K::cull_backfaces,
       {"cull_backfaces", "--cull", kNoUnit, "Drop micropolygons that face away", Stated::kAlways}},
      {&K::edges,
       {"edges", "--edges", kNoUnit, "Edge equations in Test (inline) or in Bound (precomputed)"},
       kEdges},
  };
  return all;
}

/// Those that REPACK takes beside them.
inline const Parameters<KernelOptions>& repack_parameters() {
  using K = KernelOptions;
  static const Parameters<K> all{
      {&K::stream_load_threshold,
       {"stream_load_threshold", "--stream-load-threshold", "lanes / W",
        "REPACK loads when this share of the lanes is free"},
       0.0f,
       1.0f},
  };
  return all;
}

/// The options of a kernel, whichever of the parameters it takes.
KernelOptions kernel_options(const Arguments& arguments);

/// The shape of the micropolygons that the arguments of the workload ask for.
Micropolygon shape_of(const Arguments& arguments);

/// The samples of the frame that the arguments of workload and kernel ask for.
SampleGrid sample_grid(const Arguments& arguments);

}  // namespace lanescope
