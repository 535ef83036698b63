// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/micropolygon.h"

#include <algorithm>

#include "simulator/base/error.h"

namespace lanescope {

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
  copy.size_ = size_;
  std::copy_n(data_.get(), offset(corner_count(shape_), Attribute::kX), copy.data_.get());
  return copy;
}

void Packet::clear(std::uint64_t next_first_id) {
  std::fill_n(data_.get(), offset(corner_count(shape_), Attribute::kX), 0.0f);
  size_ = 0;
  first_id = next_first_id;
}

}  // namespace lanescope
