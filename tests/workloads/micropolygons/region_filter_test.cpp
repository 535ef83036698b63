// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/region_filter.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace lanescope {
namespace {

/// A packet of right triangles with their corner at (x, y) and sides of `size` cells.
Packet triangles_at(const std::vector<std::pair<float, float>>& corners, float size, int capacity) {
  Packet packet(Micropolygon::kTriangle, capacity);
  for (const auto& [x, y] : corners) {
    Vertex vertices[3];
    vertices[1][Attribute::kX] = size;
    vertices[2][Attribute::kY] = size;
    for (Vertex& vertex : vertices) {
      vertex[Attribute::kX] += x;
      vertex[Attribute::kY] += y;
    }
    packet.append(vertices);
  }
  return packet;
}

TEST(RegionFilter, KeepsWhatMeetsTheRegionInOrder) {
  // The region is cells 4 to 7 in both directions. Boxes end at floor(corner + 0.5).
  const Packet packet = triangles_at(
      {{3.4f, 5}, {3.5f, 5}, {7.9f, 7.9f}, {8.0f, 5}, {5, 3.4f}, {5, 8.0f}, {6, 6}}, 0.5f, 8);
  std::vector<std::vector<float>> passed;
  const WorkSink sink = [&](const Work& work) {
    const auto& p = static_cast<const Packet&>(work);
    EXPECT_EQ(p.capacity(), 8);
    passed.emplace_back(p.values(0, Attribute::kX), p.values(0, Attribute::kX) + p.size());
  };
  PacketRegionFilter filter({2, 2, 2, 2}, 2);
  filter.take(packet, sink);
  EXPECT_TRUE(passed.empty());
  for (int i = 0; i < 2; ++i) filter.take(packet, sink);
  filter.flush(sink);
  EXPECT_EQ(passed,
            (std::vector<std::vector<float>>{{3.5f, 7.9f, 6, 3.5f, 7.9f, 6, 3.5f, 7.9f}, {6}}));
}

}  // namespace
}  // namespace lanescope
