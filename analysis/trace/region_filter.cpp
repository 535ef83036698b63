// SPDX-License-Identifier: MIT
#include "analysis/trace/region_filter.h"

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

RegionFilter::RegionFilter(const Region& region, int samples_per_axis, Sink sink)
    : left_(static_cast<float>(region.x_px * samples_per_axis)),
      right_(static_cast<float>((region.x_px + region.width_px) * samples_per_axis)),
      top_(static_cast<float>(region.y_px * samples_per_axis)),
      bottom_(static_cast<float>((region.y_px + region.height_px) * samples_per_axis)),
      sink_(std::move(sink)) {}

bool RegionFilter::meets(const Packet& packet, int i) const {
  const auto [first_column, last_column] = span_of(packet, Attribute::kX, i);
  const auto [first_row, last_row] = span_of(packet, Attribute::kY, i);
  return first_column < right_ && last_column >= left_ && first_row < bottom_ && last_row >= top_;
}

void RegionFilter::take(const Packet& packet) {
  if (!held_) held_.emplace(packet.shape(), packet.capacity());
  for (int i = 0; i < packet.size(); ++i) {
    if (!meets(packet, i)) continue;
    Vertex corners[4];
    for (int k = 0; k < corner_count(packet.shape()); ++k)
      for (int a = 0; a < kAttributeCount; ++a)
        corners[k].attributes[static_cast<std::size_t>(a)] =
            packet.values(k, static_cast<Attribute>(a))[i];
    held_->append(corners);
    if (held_->full()) flush();
  }
}

void RegionFilter::flush() {
  if (!held_ || held_->size() == 0) return;
  sink_(*held_);
  held_->clear(0);
}

}  // namespace lanescope
