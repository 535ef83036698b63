// SPDX-License-Identifier: MIT
#include "tests/kernels/micropolygons/runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/check.h"
#include "tests/simulator/counting_observer.h"
#include "workloads/micropolygons/grid.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope::test {
namespace {

/// Whether corners are farther out than in any packet of a source, so that products overflow. What
/// comes of it kernels take as it is: it hits nothing, or has no colour.
bool may_overflow(const Packet& packet) {
  for (int corner = 0; corner < corner_count(packet.shape()); ++corner)
    for (const Attribute coordinate : {Attribute::kX, Attribute::kY})
      for (int i = 0; i < packet.size(); ++i)
        if (!(std::abs(packet.values(corner, coordinate)[i]) <= kMaxCoordinateCells)) return true;
  return false;
}

}  // namespace

std::vector<const Kernel*> rasterizers() {
  std::vector<const Kernel*> all = kernels();
  std::erase_if(all, [](const Kernel* kernel) { return kernel->workload != &w_micropolygons; });
  return all;
}

Arguments arguments_of(const KernelOptions& options, Micropolygon shape) {
  Arguments arguments = encoded(raster_parameters(), options);
  for (const auto& [name, value] : encoded(repack_parameters(), options).all())
    arguments.set(name, value);
  arguments.set("micropolygon", std::string(name_of(kShapes, shape)));
  return arguments;
}

std::uint64_t Outcome::counter(const Kernel& kernel, std::string_view name) const {
  for (std::size_t i = 0; i < kernel.counters.size(); ++i)
    if (kernel.counters[i].name == name) return result.counters[i];
  ADD_FAILURE() << kernel.name << " has no counter " << name;
  return 0;
}

Outcome run(const Kernel& kernel, int width, Mode mode, const KernelOptions& options,
            const SampleGrid& grid, const std::vector<const Packet*>& packets) {
  Frame frame(grid);
  CountingObserver observer(width, kernel.stages.size());
  const Arguments arguments = arguments_of(options, packets.front()->shape());
  const auto execution =
      kernel.start({width, mode, arguments, frame, mode == Mode::kTracing ? &observer : nullptr});
  for (const Packet* packet : packets) execution->run(*packet);
  Outcome outcome{execution->result(), frame.hash()};
  if (mode == Mode::kTracing) outcome.result.counts = observer.counts();
  return outcome;
}

Packet packet_of(Micropolygon shape,
                 const std::vector<std::vector<std::pair<float, float>>>& polygons) {
  Packet packet(shape, static_cast<int>(polygons.size()));
  for (const auto& polygon : polygons) {
    Vertex corners[4];
    for (std::size_t k = 0; k < polygon.size(); ++k)
      corners[k] = {{polygon[k].first, polygon[k].second, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f}};
    packet.append(corners);
  }
  return packet;
}

Packet squares(int columns, int rows, float size) {
  std::vector<std::vector<std::pair<float, float>>> polygons;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float x = static_cast<float>(column) * size, y = static_cast<float>(row) * size;
      polygons.push_back({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
    }
  }
  return packet_of(Micropolygon::kQuad, polygons);
}

void expect_same(const Kernel& kernel, const Outcome& outcome, const Outcome& reference) {
  const Kernel& scalar = find_kernel("rastmp");
  EXPECT_EQ(outcome.result.results_hash, reference.result.results_hash);
  EXPECT_EQ(outcome.frame_hash, reference.frame_hash);
  for (const CounterInfo& info : scalar.counters)
    EXPECT_EQ(outcome.counter(kernel, info.name), reference.counter(scalar, info.name))
        << info.name;
}

void expect_agreement(const Packet& packet, const SampleGrid& grid, bool cull_backfaces,
                      const std::vector<int>& widths) {
  const bool overflows = may_overflow(packet);
  for (const Edges edges : {Edges::kInline, Edges::kPrecomputed}) {
    KernelOptions options;
    options.edges = edges;
    options.cull_backfaces = cull_backfaces;
    const Kernel& scalar = find_kernel("rastmp");
    const Outcome reference = run(scalar, 1, Mode::kCounting, options, grid, {&packet});
    for (const Kernel* kernel : rasterizers()) {
      for (const int width : widths) {
        if (width > kernel->most_width) continue;
        for (const Mode mode :
             {Mode::kCounting, Mode::kChecked, Mode::kTracing, Mode::kUncounted}) {
          SCOPED_TRACE(fmt::format("{}, W = {}, {}, {} edges", kernel->name, width, to_string(mode),
                                   edges == Edges::kInline ? "inline" : "precomputed"));
          Outcome outcome;
          try {
            outcome = run(*kernel, width, mode, options, grid, {&packet});
          } catch (const FailedCheck& e) {
            EXPECT_TRUE(overflows && (e.check() == Check::kNan || e.check() == Check::kConversion))
                << e.what();
            continue;
          }
          if (mode == Mode::kUncounted) {
            EXPECT_EQ(outcome.result.results_hash, reference.result.results_hash);
            EXPECT_EQ(outcome.frame_hash, reference.frame_hash);
          } else {
            expect_same(*kernel, outcome, reference);
          }
        }
      }
    }
  }
}

}  // namespace lanescope::test
