// SPDX-License-Identifier: MIT
// REPACK whose hits carry the values of the edge functions from *Test* to *Process*, in a record of
// four words, where otherwise *Process* evaluates them again.
#pragma once

#include <tuple>

#include "kernels/micropolygons/repack.h"
#include "scatter_record.h"

namespace lanescope {

/// A policy of the form of NothingCarried, which see. Triangles leave the fourth word empty.
struct EdgesCarried {
  static constexpr int kWords = 4;

  template <class On, class Places, class Vm, Micropolygon P>
  static void push(On& on, Memory<float> buffer, const Places& places,
                   const EdgeValues<Vm, P>& values) {
    const auto& e = values.e;
    scatter_record(on, buffer, places, e[0], e[1], e[2], e[kCorners<P> - 1]);
  }

  template <class Vm, Micropolygon P, class On>
  static EdgeValues<Vm, P> load(On& on, Memory<float> buffer, std::int64_t first) {
    const auto record = load_record(on, buffer, first);
    EdgeValues<Vm, P> values;
    values.e[0] = record.first.first;
    values.e[1] = record.first.second;
    values.e[2] = record.second.first;
    values.e[kCorners<P> - 1] = record.second.second;
    return values;
  }
};

struct StepsWithRecords : PlainSteps {
  using Carried = EdgesCarried;
};

template <class Vm, Micropolygon P, Edges E>
using RepackRecords = BasicRepack<Vm, P, E, StepsWithRecords>;

}  // namespace lanescope
