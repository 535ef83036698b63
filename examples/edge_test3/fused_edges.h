// SPDX-License-Identifier: MIT
// *Test* of triangles in one instruction. The values of the edge functions, which weights are made
// of, are evaluated in *Process*, for hits alone.
#pragma once

#include <tuple>

#include "edge_test3.h"
#include "kernels/micropolygons/steps.h"

namespace lanescope {

/// A policy of the form of EdgesOneByOne, which see, and which it is for quads.
struct FusedEdges {
  static constexpr bool kGivesValues = false;

  template <class Vm, Micropolygon P, class On>
  static Coverage<Vm> test(On& on, const Positions<Vm, P>& p, const typename Vm::Float& px,
                           const typename Vm::Float& py, EdgeValues<Vm, P>& values) {
    if constexpr (P == Micropolygon::kQuad) {
      return EdgesOneByOne::test<Vm, P>(on, p, px, py, values);
    } else {
      Coverage<Vm> coverage;
      std::tie(coverage.inside, coverage.on_edge) =
          edge_test3(on, p.x[0], p.y[0], p.x[1], p.y[1], p.x[2], p.y[2], px, py);
      coverage.any_inside = any(on, coverage.inside);
      coverage.any_on_edge = any(on, coverage.on_edge);
      return coverage;
    }
  }
};

struct StepsWithFusedEdges : PlainSteps {
  using EdgeTest = FusedEdges;
};

}  // namespace lanescope
