// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/options.h"

#include "workloads/micropolygons/options.h"

namespace lanescope {

KernelOptions kernel_options(const Arguments& arguments) {
  KernelOptions options = decoded(raster_parameters(), arguments);
  options.stream_load_threshold = decoded(repack_parameters(), arguments).stream_load_threshold;
  return options;
}

Micropolygon shape_of(const Arguments& arguments) {
  return decoded(tessellation_parameters(), arguments).shape;
}

SampleGrid sample_grid(const Arguments& arguments) {
  const auto frame = decoded(tessellation_parameters(), arguments);
  const auto sampling = decoded(sampling_parameters(), arguments);
  return {frame.width_px, frame.height_px, frame.samples_per_pixel, sampling.jitter, sampling.seed};
}

}  // namespace lanescope
