// SPDX-License-Identifier: MIT
// Micropolygons as the kernels read them: packets in structure-of-arrays form, in tessellator
// order. Plain data; coordinates are defined in docs/conventions.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string_view>

#include "simulator/base/choice.h"
#include "workloads/work.h"

namespace lanescope {

/// The shape of a micropolygon; the value is its number of corners.
enum class Micropolygon { kTriangle = 3, kQuad = 4 };

constexpr int corner_count(Micropolygon micropolygon) { return static_cast<int>(micropolygon); }
inline constexpr std::array<Choice<Micropolygon>, 2> kShapes{
    {{"triangle", Micropolygon::kTriangle}, {"quad", Micropolygon::kQuad}}};

/// A vertex is seven floats, 28 bytes (the thesis, 3.2.1): position in sub-pixel cells with y down
/// (x and y are multiples of kSubpixel), depth (smaller is nearer, positive), and colour in [0, 1].
enum class Attribute { kX, kY, kZ, kRed, kGreen, kBlue, kAlpha };
inline constexpr int kAttributeCount = 7;

/// Vertices lie on a grid of 1/256 of a cell, as in hardware rasterizers: edge functions of
/// micropolygons up to 16 x 16 cells are then exact in single precision.
inline constexpr float kSubpixel = 1.0f / 256.0f;

struct Vertex {
  std::array<float, kAttributeCount> attributes{};
  float& operator[](Attribute a) { return attributes[static_cast<std::size_t>(a)]; }
  float operator[](Attribute a) const { return attributes[static_cast<std::size_t>(a)]; }
};

/// A run of micropolygons in tessellator order: what a kernel gets at a time and keeps in memory
/// until it has drained. Corners of a quad go around; a triangle pair of one quad is (0, 1, 2) and
/// (0, 2, 3). Positive area, by (x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0), faces the viewer.
///
/// Every array holds `padded_capacity` floats (a multiple of 64, the widest machine), zero beyond
/// `size`, so that whole vectors can be loaded anywhere in it.
class Packet final : public Work {
 public:
  /// Requires capacity > 0.
  Packet(Micropolygon shape, int capacity);

  Micropolygon shape() const { return shape_; }
  int size() const { return size_; }
  int capacity() const { return capacity_; }
  int padded_capacity() const { return padded_capacity_; }
  bool full() const { return size_ == capacity_; }

  std::uint64_t element_count() const override { return static_cast<std::uint64_t>(size_); }
  std::uint64_t hash() const override;

  /// Identity of the first micropolygon in the scene; micropolygon i of the packet is first_id + i.
  /// The same at any number of threads.
  std::uint64_t first_id = 0;

  /// [padded_capacity] values of one attribute of one corner.
  const float* values(int corner, Attribute attribute) const {
    return data_.get() + offset(corner, attribute);
  }

  /// Appends a micropolygon; `corners` points to corner_count(shape()) vertices. Requires !full().
  void append(const Vertex* corners);

  /// A copy, for those who keep packets; copies are too large to be made unawares.
  Packet clone() const;

  /// Empties the packet (and zeroes it); the next packet starts at id `next_first_id`.
  void clear(std::uint64_t next_first_id);

 private:
  struct AlignedDelete {
    void operator()(float* p) const { ::operator delete[](p, std::align_val_t{64}); }
  };
  std::size_t offset(int corner, Attribute attribute) const {
    return static_cast<std::size_t>(corner * kAttributeCount + static_cast<int>(attribute)) *
           static_cast<std::size_t>(padded_capacity_);
  }

  Micropolygon shape_;
  int capacity_;
  int padded_capacity_;
  int size_ = 0;
  std::unique_ptr<float[], AlignedDelete> data_;
};

}  // namespace lanescope
