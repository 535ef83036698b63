// SPDX-License-Identifier: MIT
// What the voxel kernels are started with.
#pragma once

#include "simulator/base/parameter.h"
#include "workloads/voxels/options.h"

namespace lanescope {

struct ProbeOptions {
  /// Lanes merge when at least this share of those at work has a filled cube.
  float merge_threshold = 0.625f;
};

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
  return decoded(merge_parameters(), arguments);
}

/// The projection that the arguments of the workload ask for.
inline Projection projection_of(const Arguments& arguments) {
  return decoded(world_parameters(), arguments).projection;
}

}  // namespace lanescope
