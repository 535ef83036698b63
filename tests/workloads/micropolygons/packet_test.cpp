// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdint>

#include "simulator/base/error.h"
#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {
namespace {

Vertex vertex(float base) {
  Vertex v;
  for (int a = 0; a < kAttributeCount; ++a)
    v[static_cast<Attribute>(a)] = base + static_cast<float>(a);
  return v;
}

TEST(Packet, KeepsCornersApartAndIsZeroBeyondItsSize) {
  Packet packet(Micropolygon::kQuad, 100);
  EXPECT_EQ(packet.padded_capacity(), 128);
  const Vertex corners[] = {vertex(10), vertex(20), vertex(30), vertex(40)};
  packet.append(corners);
  EXPECT_EQ(packet.size(), 1);
  for (int corner = 0; corner < 4; ++corner)
    for (int a = 0; a < kAttributeCount; ++a) {
      const float* values = packet.values(corner, static_cast<Attribute>(a));
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(values) % 64, 0u);
      EXPECT_EQ(values[0], static_cast<float>(10 * (corner + 1) + a));
      for (int i = 1; i < packet.padded_capacity(); ++i) ASSERT_EQ(values[i], 0.0f);
    }
}

TEST(Packet, ClearingEmptiesItAndMovesItsIds) {
  Packet packet(Micropolygon::kTriangle, 2);
  const Vertex corners[] = {vertex(1), vertex(2), vertex(3)};
  packet.append(corners);
  packet.append(corners);
  EXPECT_TRUE(packet.full());
  EXPECT_THROW(packet.append(corners), CheckError);
  packet.clear(77);
  EXPECT_EQ(packet.size(), 0);
  EXPECT_EQ(packet.first_id, 77u);
  EXPECT_EQ(packet.values(2, Attribute::kAlpha)[1], 0.0f);
}

TEST(Packet, NeedsRoom) { EXPECT_THROW(Packet(Micropolygon::kQuad, 0), CheckError); }

}  // namespace
}  // namespace lanescope
