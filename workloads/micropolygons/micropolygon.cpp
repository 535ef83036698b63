// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/micropolygon.h"

#include <algorithm>
#include <array>
#include <bit>

#include "simulator/base/error.h"
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

Packet::Packet(Micropolygon shape, int capacity)
    : shape_(shape), capacity_(capacity), padded_capacity_((capacity + 63) / 64 * 64) {
  LANESCOPE_CHECK(capacity > 0, "capacity {}", capacity);
  const std::size_t floats = offset(corner_count(shape), Attribute::kX);
  data_.reset(static_cast<float*>(::operator new[](floats * sizeof(float), std::align_val_t{64})));
  std::fill_n(data_.get(), floats, 0.0f);
}

void Packet::append(const Vertex* corners) {
  LANESCOPE_CHECK(!full(), "packet of {}", capacity_);
  for (int corner = 0; corner < corner_count(shape_); ++corner)
    for (int a = 0; a < kAttributeCount; ++a)
      data_[offset(corner, static_cast<Attribute>(a)) + static_cast<std::size_t>(size_)] =
          corners[corner][static_cast<Attribute>(a)];
  ++size_;
}

Packet Packet::clone() const {
  Packet copy(shape_, capacity_);
  copy.first_id = first_id;
  copy.segment = segment;
  copy.ordinal = ordinal;
  copy.size_ = size_;
  std::copy_n(data_.get(), offset(corner_count(shape_), Attribute::kX), copy.data_.get());
  return copy;
}

void Packet::clear(std::uint64_t next_first_id) {
  std::fill_n(data_.get(), offset(corner_count(shape_), Attribute::kX), 0.0f);
  size_ = 0;
  first_id = next_first_id;
}

std::uint64_t Packet::hash() const {
  static_assert(64 % kChains == 0, "padding must fill whole steps");
  std::uint64_t hash = mix64(first_id) ^ mix64(static_cast<std::uint64_t>(size_) + 1);
  for (int corner = 0; corner < corner_count(shape_); ++corner)
    for (int a = 0; a < kAttributeCount; ++a)
      hash = mix64(hash ^ hash_values(values(corner, static_cast<Attribute>(a)), size_));
  return hash;
}

}  // namespace lanescope
