// SPDX-License-Identifier: MIT
// REPACK's time over LOCKSTEP's on this host, uncounted, beside their instructions: what machine
// descriptions of the host's kind (docs/machines.md) are held against. The scene is ballroll at
// 480 x 300.
#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "benchmarks/packets.h"
#include "benchmarks/timing.h"
#include "kernels/kernel.h"
#include "kernels/micropolygons/frame.h"
#include "workloads/micropolygons/options.h"

namespace lanescope {
namespace {

/// A kernel at one width, on packets that it takes again and again.
class Runs {
 public:
  Runs(std::string_view kernel, int width, Micropolygon shape, const std::vector<Packet>& packets)
      : kernel_(find_kernel(kernel)), width_(width), packets_(packets) {
    TessellationOptions options;
    options.shape = shape;
    arguments_ = encoded(tessellation_parameters(), options);
  }

  auto timed() {
    return [this, execution = start(Mode::kUncounted)] {
      for (const Packet& packet : packets_) execution->run(packet);
    };
  }

  double instructions() {
    const auto execution = start(Mode::kCounting);
    for (const Packet& packet : packets_) execution->run(packet);
    double issued = 0.0;
    for (const StageCounts& stage : execution->result().counts.stages)
      issued += static_cast<double>(stage.total().issued);
    return issued;
  }

 private:
  std::unique_ptr<Execution> start(Mode mode) {
    return kernel_.start({width_, mode, arguments_, frame_});
  }

  const Kernel& kernel_;
  int width_;
  const std::vector<Packet>& packets_;
  Arguments arguments_;
  Frame frame_{SampleGrid(benchmarks::kWidthPx, benchmarks::kHeightPx, 4, true, 1)};
};

void measure(Micropolygon shape, std::string_view name) {
  const auto packets = benchmarks::make_packets(shape);
  for (const int width : {8, 16, 32, 64}) {
    Runs lockstep("lockstep", width, shape, packets), repack("repack", width, shape, packets);
    fmt::print("{:<12} {:>2} {:>24.3f} {:>32.3f}\n", name, width,
               benchmarks::ratio(repack.timed(), lockstep.timed()),
               repack.instructions() / lockstep.instructions());
  }
}

}  // namespace
}  // namespace lanescope

int main() {
  using lanescope::Micropolygon;
  fmt::print(
      "Medians of {} rounds\n\nmicropolygon  W   REPACK / LOCKSTEP, time   REPACK / LOCKSTEP, "
      "instructions\n",
      lanescope::benchmarks::kRounds);
  lanescope::measure(Micropolygon::kTriangle, "triangle");
  lanescope::measure(Micropolygon::kQuad, "quad");
  return EXIT_SUCCESS;
}
