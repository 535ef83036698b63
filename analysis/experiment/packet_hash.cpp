// SPDX-License-Identifier: MIT
#include "analysis/experiment/packet_hash.h"

#include <array>
#include <bit>

#include "simulator/base/random.h"

namespace lanescope {
namespace {

/// Independent chains, so that the loop over a packet's values becomes vector instructions.
constexpr int kChains = 16;
constexpr std::uint32_t kMultiplier = 0x9e3779b1u;  // Odd: no bit is lost.

std::uint64_t hash_values(const float* values, int size) {
  std::array<std::uint32_t, kChains> chains{};
  for (int i = 0; i < size; i += kChains)
    for (int chain = 0; chain < kChains; ++chain) {
      const auto c = static_cast<std::size_t>(chain);
      const std::uint32_t mixed =
          (chains[c] ^ std::bit_cast<std::uint32_t>(values[i + chain])) * kMultiplier;
      chains[c] = mixed ^ (mixed >> 15);
    }
  std::uint64_t hash = 0;
  for (const std::uint32_t chain : chains) hash = mix64(hash ^ chain);
  return hash;
}

}  // namespace

std::uint64_t packet_hash(const Packet& packet) {
  static_assert(64 % kChains == 0, "padding must fill whole steps");
  std::uint64_t hash =
      mix64(packet.first_id) ^ mix64(static_cast<std::uint64_t>(packet.size()) + 1);
  for (int corner = 0; corner < corner_count(packet.shape()); ++corner)
    for (int a = 0; a < kAttributeCount; ++a)
      hash = mix64(hash ^
                   hash_values(packet.values(corner, static_cast<Attribute>(a)), packet.size()));
  return hash;
}

}  // namespace lanescope
