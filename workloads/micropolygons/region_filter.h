// SPDX-License-Identifier: MIT
// The micropolygons of a part of the frame, in packets.
#pragma once

#include <optional>

#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {

/// Passes on the micropolygons whose bounding box meets a region, in their order, in packets of the
/// capacity of those that come in. Ids are not kept.
class PacketRegionFilter final : public RegionFilter {
 public:
  /// Packets are in cells, of which a pixel has `samples_per_axis` along each side.
  PacketRegionFilter(const Region& region, int samples_per_axis);

  void take(const Work& packet, const WorkSink& sink) override;
  void flush(const WorkSink& sink) override;

 private:
  bool meets(const Packet& packet, int i) const;

  float left_, right_, top_, bottom_;  ///< In cells; right and bottom are outside.
  std::optional<Packet> held_;
};

}  // namespace lanescope
