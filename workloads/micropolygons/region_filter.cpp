// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/region_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanescope {
namespace {

/// The cells that the corners span along one axis, snapped outward (docs/conventions.md, "Boxes").
std::pair<float, float> span_of(const Packet& packet, Attribute axis, int i) {
  float low = packet.values(0, axis)[i];
  float high = low;
  for (int k = 1; k < corner_count(packet.shape()); ++k) {
    low = std::min(low, packet.values(k, axis)[i]);
    high = std::max(high, packet.values(k, axis)[i]);
  }
  return {std::floor(low), std::floor(high)};
}

}  // namespace

PacketRegionFilter::PacketRegionFilter(const Region& region, int samples_per_axis)
    : left_(static_cast<float>(region.x_px * samples_per_axis)),
      right_(static_cast<float>((region.x_px + region.width_px) * samples_per_axis)),
      top_(static_cast<float>(region.y_px * samples_per_axis)),
      bottom_(static_cast<float>((region.y_px + region.height_px) * samples_per_axis)) {}

bool PacketRegionFilter::meets(const Packet& packet, int i) const {
  const auto [first_column, last_column] = span_of(packet, Attribute::kX, i);
  const auto [first_row, last_row] = span_of(packet, Attribute::kY, i);
  return first_column < right_ && last_column >= left_ && first_row < bottom_ && last_row >= top_;
}

void PacketRegionFilter::take(const Work& work, const WorkSink& sink) {
  const auto& packet = static_cast<const Packet&>(work);
  if (!held_) held_.emplace(packet.shape(), packet.capacity());
  for (int i = 0; i < packet.size(); ++i) {
    if (!meets(packet, i)) continue;
    Vertex corners[4];
    for (int k = 0; k < corner_count(packet.shape()); ++k)
      for (int a = 0; a < kAttributeCount; ++a)
        corners[k].attributes[static_cast<std::size_t>(a)] =
            packet.values(k, static_cast<Attribute>(a))[i];
    held_->append(corners);
    if (held_->full()) flush(sink);
  }
}

void PacketRegionFilter::flush(const WorkSink& sink) {
  if (!held_ || held_->size() == 0) return;
  sink(*held_);
  held_->clear(0);
}

}  // namespace lanescope
