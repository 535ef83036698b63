// SPDX-License-Identifier: MIT
// What the voxel kernels are started with.
#pragma once

#include "simulator/base/parameter.h"
#include "workloads/voxels/options.h"

namespace lanescope {

struct ProbeOptions {
  /// Lanes merge when at least this share of those at work has a filled cube.
  float merge_threshold = 0.625f;
  /// Octants share a vector if at least so many of their images fit.
  int least_side_by_side = 4;
};

/// Of across_image.
inline const Parameters<ProbeOptions>& packing_parameters() {
  using P = ProbeOptions;
  static const Parameters<P> all{
      {&P::least_side_by_side,
       {"least_side_by_side", "--side-by-side", "octants",
        "Octants share a vector if at least N of their images fit"},
       2,
       8},
  };
  return all;
}

/// Of repacked_cameras.
inline const Parameters<ProbeOptions>& merge_parameters() {
  using P = ProbeOptions;
  static const Parameters<P> all{
      {&P::merge_threshold,
       {"merge_threshold", "--merge-threshold", "lanes / lanes at work",
        "Lanes merge when this share of them has found a filled cube"},
       0.0f,
       1.0f},
  };
  return all;
}

struct ErrorOptions {
  int measured_every = 4;
};

/// Of sky_error.
inline const Parameters<ErrorOptions>& error_parameters() {
  static const Parameters<ErrorOptions> all{
      {&ErrorOptions::measured_every,
       {"measured_every", "--measured-every", "probes", "One probe of N is measured"},
       1,
       1 << 20},
  };
  return all;
}

/// The options of a kernel, whichever of the parameters it takes.
inline ProbeOptions probe_options(const Arguments& arguments) {
  ProbeOptions options = decoded(merge_parameters(), arguments);
  options.least_side_by_side = decoded(packing_parameters(), arguments).least_side_by_side;
  return options;
}

/// The projection that the arguments of the workload ask for.
inline SkyProjection projection_of(const Arguments& arguments) {
  return decoded(world_parameters(), arguments).projection;
}

}  // namespace lanescope
