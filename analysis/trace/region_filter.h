// SPDX-License-Identifier: MIT
// The micropolygons of a part of the frame, in packets.
#pragma once

#include <functional>
#include <optional>

#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {

/// A rectangle of the frame, in pixels from its upper left corner.
struct Region {
  int x_px, y_px, width_px, height_px;
};

/// Passes on the micropolygons whose bounding box meets a region, in their order, in packets of the
/// capacity of those that come in. Ids are not kept.
class RegionFilter {
 public:
  using Sink = std::function<void(const Packet&)>;

  /// Packets are in cells, of which a pixel has `samples_per_axis` along each side.
  RegionFilter(const Region& region, int samples_per_axis, Sink sink);

  void take(const Packet& packet);
  /// Passes on what is left.
  void flush();

 private:
  bool meets(const Packet& packet, int i) const;

  float left_, right_, top_, bottom_;  ///< In cells; right and bottom are outside.
  Sink sink_;
  std::optional<Packet> held_;
};

}  // namespace lanescope
