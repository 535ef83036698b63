// SPDX-License-Identifier: MIT
#include "benchmarks/packets.h"

#include "workloads/micropolygons/surface_scene.h"
#include "workloads/micropolygons/tessellator.h"

namespace lanescope::benchmarks {

std::vector<Packet> make_packets(Micropolygon shape) {
  const SurfaceScene& descriptor = find_surface_scene("ballroll");
  const Scene scene = descriptor.build(descriptor.default_frame);
  TessellationOptions options;
  options.width_px = kWidthPx;
  options.height_px = kHeightPx;
  options.shape = shape;
  const Tessellator tessellator(scene, options);
  std::vector<Packet> packets;
  for (int segment = 0; segment < tessellator.segment_count(); ++segment)
    tessellator.tessellate(segment,
                           [&](const Packet& packet) { packets.push_back(packet.clone()); });
  return packets;
}

}  // namespace lanescope::benchmarks
