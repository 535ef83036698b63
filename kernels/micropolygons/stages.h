// SPDX-License-Identifier: MIT
// What LOCKSTEP and REPACK do alike, as pieces of a vector program: cull, bound, place a sample,
// evaluate edges, interpolate. Each function issues its instructions in the block it is given, so
// the caller decides the stage, the mask and what is overhead.
#pragma once

#include <array>

#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame_merge.h"
#include "simulator/instruction_set.h"
#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {

using namespace isa;

template <Micropolygon P>
inline constexpr int kCorners = corner_count(P);

/// Interpolated attributes: depth, red, green, blue, alpha.
inline constexpr int kShades = kAttributeCount - 2;

/// The arrays of a packet as memory of the machine.
template <Micropolygon P>
struct PacketMemory {
  PacketMemory() = default;
  explicit PacketMemory(const Packet& packet) {
    for (int k = 0; k < kCorners<P>; ++k) {
      for (int a = 0; a < kAttributeCount; ++a)
        attributes[k][a] = read_only(packet.values(k, static_cast<Attribute>(a)),
                                     static_cast<std::size_t>(packet.padded_capacity()), "packet");
    }
  }
  const Memory<const float>& x(int corner) const { return attributes[corner][0]; }
  const Memory<const float>& y(int corner) const { return attributes[corner][1]; }
  const Memory<const float>& shade(int corner, int i) const { return attributes[corner][2 + i]; }

  Memory<const float> attributes[kCorners<P>][kAttributeCount];
};

/// The frame's cells as the stages need them.
struct Cells {
  explicit Cells(const SampleGrid& grid)
      : last_column(static_cast<float>(grid.width_cells() - 1)),
        last_row(static_cast<float>(grid.height_cells() - 1)),
        stride(grid.width_cells()),
        jitter(read_only(grid.jitter().data(), grid.jitter().size(), "jitter")) {}

  float last_column;
  float last_row;
  std::int32_t stride;  ///< Samples in a row.
  Memory<const float> jitter;
};

template <class Vm, Micropolygon P>
struct Positions {
  typename Vm::Float x[kCorners<P>], y[kCorners<P>];
};

/// Positions of the micropolygons `first` ... of a packet.
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE Positions<Vm, P> load_positions(On& on, const PacketMemory<P>& packet,
                                                 std::int64_t first) {
  Positions<Vm, P> p;
  host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    p.x[k] = load(on, packet.x(k), first);
    p.y[k] = load(on, packet.y(k), first);
  });
  return p;
}

/// a x b of plane vectors.
template <class On, class Float>
LANESCOPE_INLINE Float cross(On& on, const Float& ax, const Float& ay, const Float& bx,
                             const Float& by) {
  return sub(on, mul(on, ax, by), mul(on, ay, bx));
}

/// Twice the area, positive if it faces the viewer; of a quad from its diagonals.
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE typename Vm::Float doubled_area(On& on, const Positions<Vm, P>& p) {
  constexpr bool kTriangle = P == Micropolygon::kTriangle;
  constexpr int kFirstTo = kTriangle ? 1 : 2;
  constexpr int kSecondFrom = kTriangle ? 0 : 1;
  constexpr int kSecondTo = kTriangle ? 2 : 3;
  return cross(on, sub(on, p.x[kFirstTo], p.x[0]), sub(on, p.y[kFirstTo], p.y[0]),
               sub(on, p.x[kSecondTo], p.x[kSecondFrom]),
               sub(on, p.y[kSecondTo], p.y[kSecondFrom]));
}

/// The candidates of a micropolygon: cells of its bounding box, snapped outward and clipped to the
/// frame, row by row.
template <class Vm>
struct Box {
  typename Vm::Float first_column, last_column, first_row;
  typename Vm::Int candidates;    ///< Number of cells, 0 if off screen.
  typename Vm::Int first_sample;  ///< Index of the sample of the first cell.
  typename Vm::Int row_step;      ///< From the last sample of a row to the first of the next.
};

/// Largest (or smallest) coordinate of the corners.
template <Micropolygon P, class Op, class On, class Float>
LANESCOPE_INLINE Float extreme(const Op& op, On& on, const Float (&c)[kCorners<P>]) {
  if constexpr (P == Micropolygon::kTriangle)
    return op(on, op(on, c[0], c[1]), c[2]);
  else
    return op(on, op(on, op(on, c[0], c[1]), c[2]), c[3]);
}

/// *Bound*: the bounding box (the thesis, 3.1).
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE Box<Vm> bound(On& on, const Positions<Vm, P>& p, const Cells& cells) {
  Box<Vm> box;
  box.first_column = max(on, floor(on, extreme<P>(min, on, p.x)), 0.0f);
  box.last_column = min(on, floor(on, extreme<P>(max, on, p.x)), cells.last_column);
  box.first_row = max(on, floor(on, extreme<P>(min, on, p.y)), 0.0f);
  const auto last_row = min(on, floor(on, extreme<P>(max, on, p.y)), cells.last_row);
  const auto cells_between = [&](const auto& from, const auto& to) LANESCOPE_INLINE_LAMBDA {
    return convert_to_int(on, max(on, add(on, sub(on, to, from), 1.0f), 0.0f));
  };
  const auto columns = cells_between(box.first_column, box.last_column);
  const auto rows = cells_between(box.first_row, last_row);
  box.candidates = mul(on, columns, rows);
  box.first_sample = add(on, mul(on, convert_to_int(on, box.first_row), cells.stride),
                         convert_to_int(on, box.first_column));
  box.row_step = sub(on, cells.stride + 1, columns);
  return box;
}

/// Where each lane is in its box.
template <class Vm>
struct Cursor {
  typename Vm::Float column, row;
  typename Vm::Int sample;
};

/// Position of the sample of a cell: its corner plus the jitter.
template <class Vm, class On>
LANESCOPE_INLINE auto place_sample(On& on, const typename Vm::Float& column,
                                   const typename Vm::Float& row, const typename Vm::Int& sample,
                                   const Cells& cells) {
  const auto offset =
      gather_pair(on, cells.jitter, bit_and(on, sample, SampleGrid::kJitterPeriod - 1));
  return std::pair(add(on, column, offset.first), add(on, row, offset.second));
}

/// Moves to the next cell of the box.
template <class Vm, class On>
LANESCOPE_INLINE Cursor<Vm> advance(On& on, const Cursor<Vm>& at,
                                    const typename Vm::Float& first_column,
                                    const typename Vm::Float& last_column,
                                    const typename Vm::Int& row_step) {
  const auto column = add(on, at.column, 1.0f);
  const auto wrapped = cmp_gt(on, column, last_column);
  return {select(on, wrapped, first_column, column),
          select(on, wrapped, add(on, at.row, 1.0f), at.row),
          add(on, at.sample, select(on, wrapped, row_step, 1))};
}

/// Values of the edge functions at a sample, edge k from corner k to the next; positive inside.
template <class Vm, Micropolygon P>
struct EdgeValues {
  typename Vm::Float e[kCorners<P>];
};

/// Edge functions from the vertices: the cross product of the vertices relative to the sample.
/// Swapping an edge's ends negates it exactly, so neighbours agree on a shared edge.
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE EdgeValues<Vm, P> inline_edges(On& on, const Positions<Vm, P>& p,
                                                const typename Vm::Float& px,
                                                const typename Vm::Float& py) {
  typename Vm::Float x[kCorners<P>], y[kCorners<P>];
  host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    x[k] = sub(on, p.x[k], px);
    y[k] = sub(on, p.y[k], py);
  });
  EdgeValues<Vm, P> values;
  host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    constexpr int kNext = (k + 1) % kCorners<P>;
    values.e[k] = cross(on, x[k], y[k], x[kNext], y[kNext]);
  });
  return values;
}

/// Edge equations A x + B y + C relative to corner 0, where C of the edges that meet there is 0.
template <class Vm, Micropolygon P>
struct EdgeEquations {
  static constexpr int kInner = kCorners<P> - 2;  ///< Edges 1 ... kInner have a C.
  typename Vm::Float a[kCorners<P>], b[kCorners<P>], c[kInner];
};

template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE EdgeEquations<Vm, P> edge_equations(On& on, const Positions<Vm, P>& p,
                                                     const typename Vm::Float& area) {
  EdgeEquations<Vm, P> equations;
  host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    constexpr int kNext = (k + 1) % kCorners<P>;
    equations.a[k] = sub(on, p.y[k], p.y[kNext]);
    equations.b[k] = sub(on, p.x[kNext], p.x[k]);
  });
  if constexpr (P == Micropolygon::kTriangle) {
    equations.c[0] = area;
  } else {
    typename Vm::Float x[3], y[3];
    host::unroll<3>([&](auto k) LANESCOPE_INLINE_LAMBDA {
      x[k] = sub(on, p.x[k + 1], p.x[0]);
      y[k] = sub(on, p.y[k + 1], p.y[0]);
    });
    equations.c[0] = cross(on, x[0], y[0], x[1], y[1]);
    equations.c[1] = cross(on, x[1], y[1], x[2], y[2]);
  }
  return equations;
}

/// Edge functions from equations.
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE EdgeValues<Vm, P> precomputed_edges(On& on, const EdgeEquations<Vm, P>& equations,
                                                     const typename Vm::Float& origin_x,
                                                     const typename Vm::Float& origin_y,
                                                     const typename Vm::Float& px,
                                                     const typename Vm::Float& py) {
  const auto x = sub(on, px, origin_x);
  const auto y = sub(on, py, origin_y);
  EdgeValues<Vm, P> values;
  host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    const auto along_y = [&] LANESCOPE_INLINE_LAMBDA {
      if constexpr (k == 0 || k == kCorners<P> - 1)
        return mul(on, equations.b[k], y);
      else
        return fma(on, equations.b[k], y, equations.c[k - 1]);
    }();
    values.e[k] = fma(on, equations.a[k], x, along_y);
  });
  return values;
}

/// Lanes whose sample is inside, and those where it lies on an edge, which the fill rule decides.
template <class Vm>
struct Coverage {
  typename Vm::Lanes inside, on_edge;
  bool any_inside, any_on_edge;
};

/// *Test*: PointInPolygon for a convex polygon.
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE Coverage<Vm> point_in_polygon(On& on, const EdgeValues<Vm, P>& values) {
  const auto least = extreme<P>(min, on, values.e);
  Coverage<Vm> coverage;
  coverage.inside = cmp_gt(on, least, 0.0f);
  coverage.on_edge = cmp_eq(on, least, 0.0f);
  coverage.any_inside = any(on, coverage.inside);
  coverage.any_on_edge = any(on, coverage.on_edge);
  return coverage;
}

/// *Test*, rarely: the fill rule (fill_rule.h) for lanes whose sample lies on an edge. Adds those
/// that are covered to `coverage`.
template <class Vm, Micropolygon P, class TestSite>
LANESCOPE_INLINE void add_owned_samples(TestSite& site, Coverage<Vm>& coverage,
                                        const Positions<Vm, P>& p,
                                        const EdgeValues<Vm, P>& values) {
  typename Vm::Lanes covered = coverage.on_edge;
  auto on = site.on(coverage.on_edge);
  host::unroll<kCorners<P>>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    constexpr int kNext = (k + 1) % kCorners<P>;
    const auto dx = sub(on, p.x[kNext], p.x[k]);
    const auto dy = sub(on, p.y[kNext], p.y[k]);
    const auto top = mask_and(on, cmp_eq(on, dy, 0.0f), cmp_gt(on, dx, 0.0f));
    const auto owned = mask_or(on, cmp_lt(on, dy, 0.0f), top);
    const auto off_edge = cmp_ne(on, values.e[k], 0.0f);
    covered = mask_and(on, covered, mask_or(on, owned, off_edge));
  });
  coverage.any_inside |= any(on, covered);
  coverage.inside = coverage.inside | covered;
}

/// Weights of the corners at a sample: of a triangle its barycentric coordinates, of a quad the
/// bilinear weights of the ratios of distances from opposite edges.
template <class Vm, Micropolygon P, class On>
LANESCOPE_INLINE auto corner_weights(On& on, const EdgeValues<Vm, P>& values,
                                     [[maybe_unused]] const typename Vm::Float& inverse_area) {
  std::array<typename Vm::Float, kCorners<P>> w;
  const auto& e = values.e;
  if constexpr (P == Micropolygon::kTriangle) {
    w[0] = mul(on, e[1], inverse_area);
    w[1] = mul(on, e[2], inverse_area);
    w[2] = mul(on, e[0], inverse_area);
  } else {
    const auto u = div(on, e[3], add(on, e[3], e[1]));
    const auto v = div(on, e[0], add(on, e[0], e[2]));
    w[2] = mul(on, u, v);
    w[1] = sub(on, u, w[2]);
    w[3] = sub(on, v, w[2]);
    w[0] = sub(on, sub(on, 1.0f, u), w[3]);
  }
  return w;
}

/// The value of one attribute, from its values at the corners.
template <class On, class Float, std::size_t N, class AtCorner>
LANESCOPE_INLINE Float interpolate(On& on, const std::array<Float, N>& weights,
                                   AtCorner&& at_corner) {
  Float sum = mul(on, weights[0], at_corner(std::integral_constant<int, 0>{}));
  host::unroll<static_cast<int>(N) - 1>([&](auto k) LANESCOPE_INLINE_LAMBDA {
    sum = fma(on, weights[k + 1], at_corner(std::integral_constant<int, k + 1>{}), sum);
  });
  return sum;
}

}  // namespace lanescope
