// SPDX-License-Identifier: MIT
// What counting costs: W1 by hand, uncounted and counting, and the kernels uncounted and counting,
// in turn within one process; prints the median of the ratios of each round. With arguments, only
// of the works named: counting_cost [w1|lockstep|repack]...
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "benchmarks/packets.h"
#include "benchmarks/timing.h"
#include "benchmarks/w1.h"
#include "kernels/kernel.h"
#include "kernels/micropolygons/frame.h"

namespace lanescope {
namespace {

using benchmarks::kRounds;
using benchmarks::ratio;

template <int W>
void measure_w1(w1::Triangles& triangles) {
  const auto counting = [&] { w1::run_on_machine<W, Mode::kCounting>(triangles); };
  const auto uncounted = [&] { w1::run_on_machine<W, Mode::kUncounted>(triangles); };
  fmt::print("W1        {:>3} {:>22.3f}", W, ratio(counting, uncounted));
#ifdef LANESCOPE_AVX512
  fmt::print(" {:>20.3f}", ratio(uncounted, [&] { w1::run_by_hand<W>(triangles); }));
#endif
  fmt::print("\n");
}

void measure_kernel(const Kernel& kernel, int width, const std::vector<Packet>& packets) {
  const SampleGrid grid(benchmarks::kWidthPx, benchmarks::kHeightPx, 4, true, 1);
  Frame frame(grid);
  const Arguments defaults;
  const auto run = [&](Mode mode) {
    return [&, execution = kernel.start({width, mode, defaults, frame})]() mutable {
      for (const Packet& packet : packets) execution->run(packet);
    };
  };
  fmt::print("{:<9} {:>3} {:>22.3f}\n", kernel.name, width,
             ratio(run(Mode::kCounting), run(Mode::kUncounted)));
}

}  // namespace
}  // namespace lanescope

int main(int argc, char** argv) {
  using namespace lanescope;
  const auto is_wanted = [&](std::string_view work) {
    return argc == 1 || std::find(argv + 1, argv + argc, work) != argv + argc;
  };
  fmt::print("Medians of {} rounds\n\nwork        W   counting / uncounted   uncounted / by hand\n",
             kRounds);
  if (is_wanted("w1")) {
    w1::Triangles triangles = w1::make_triangles(1 << 20);
    measure_w1<16>(triangles);
    measure_w1<32>(triangles);
    measure_w1<64>(triangles);
  }
  const auto packets = benchmarks::make_packets(Micropolygon::kTriangle);
  for (const char* name : {"lockstep", "repack"})
    if (is_wanted(name))
      for (const int width : {16, 32, 64}) measure_kernel(find_kernel(name), width, packets);
  return EXIT_SUCCESS;
}
