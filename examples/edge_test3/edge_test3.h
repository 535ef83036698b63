// SPDX-License-Identifier: MIT
// A unit for PointInPolygon: the three edge functions of a triangle at a sample, and what they say
// of it, in one instruction. Edge values stay in the unit.
#pragma once

#include <utility>

#include "simulator/instruction_set.h"

namespace lanescope {

/// (inside, on_edge) = edge_test3(on, x0, y0, x1, y1, x2, y2, px, py): a std::pair of masks.
struct EdgeTest3 {
  static constexpr InstructionInfo kInfo{
      "edge_test3", "(m[i], n[i]) = (least > 0, least == 0) of the edge functions of a triangle",
      InstructionClass::kArithmetic};
  template <int L>
  static std::pair<Mask<L>, Mask<L>> apply(Mask<L> active, const Vec<float, L>& x0,
                                           const Vec<float, L>& y0, const Vec<float, L>& x1,
                                           const Vec<float, L>& y1, const Vec<float, L>& x2,
                                           const Vec<float, L>& y2, const Vec<float, L>& px,
                                           const Vec<float, L>& py) {
    std::uint64_t inside = 0, on_edge = 0;
    for_each_lane(active, [&](int i) {
      const float ax = x0[i] - px[i], ay = y0[i] - py[i];
      const float bx = x1[i] - px[i], by = y1[i] - py[i];
      const float cx = x2[i] - px[i], cy = y2[i] - py[i];
      const float least = std::min({ax * by - ay * bx, bx * cy - by * cx, cx * ay - cy * ax});
      inside |= std::uint64_t{least > 0.0f} << i;
      on_edge |= std::uint64_t{least == 0.0f} << i;
    });
    return {Mask<L>::from_bits(inside), Mask<L>::from_bits(on_edge)};
  }
};
inline constexpr Instruction<EdgeTest3> edge_test3;

}  // namespace lanescope
