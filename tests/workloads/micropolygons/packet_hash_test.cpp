// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {
namespace {

Packet packet(float last_x, std::uint64_t first_id, int size) {
  Packet result(Micropolygon::kTriangle, 100);
  result.clear(first_id);
  for (int i = 0; i < size; ++i) {
    Vertex corners[3];
    corners[0][Attribute::kX] = static_cast<float>(i);
    corners[2][Attribute::kX] = i + 1 == size ? last_x : 1.0f;
    result.append(corners);
  }
  return result;
}

TEST(PacketHash, IsOfEveryValueAndOfThePlace) {
  const std::set<std::uint64_t> hashes{
      packet(0.0f, 0, 0).hash(),         packet(0.0f, 0, 70).hash(), packet(0.0f, 0, 71).hash(),
      packet(0.00390625f, 0, 70).hash(), packet(0.0f, 1, 70).hash(), packet(0.0f, 70, 70).hash()};
  EXPECT_EQ(hashes.size(), 6u);
  EXPECT_EQ(packet(2.0f, 3, 70).hash(), packet(2.0f, 3, 70).hash());
}

}  // namespace
}  // namespace lanescope
