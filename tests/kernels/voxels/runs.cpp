// SPDX-License-Identifier: MIT
#include "tests/kernels/voxels/runs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/voxels/options.h"
#include "tests/simulator/counting_observer.h"
#include "workloads/voxels/voxel_source.h"
#include "workloads/voxels/workload.h"

namespace lanescope::test {
namespace {

std::uint64_t probe_count(const std::vector<Brick>& bricks) {
  std::uint64_t count = 0;
  for (const Brick& brick : bricks)
    count = std::max(count, brick.first_probe + brick.probes.size());
  return count;
}

}  // namespace

std::vector<const Kernel*> voxel_programs() {
  std::vector<const Kernel*> all = kernels();
  std::erase_if(all, [](const Kernel* kernel) {
    return kernel->workload != &w_voxels || kernel->stages.empty();
  });
  return all;
}

std::uint64_t Rendered::counter(const Kernel& kernel, std::string_view name) const {
  for (std::size_t i = 0; i < kernel.counters.size(); ++i)
    if (kernel.counters[i].name == name) return result.counters[i];
  ADD_FAILURE() << kernel.name << " has no counter " << name;
  return 0;
}

Rendered render(const Kernel& kernel, int width, Mode mode, SkyProjection projection,
                const std::vector<Brick>& bricks) {
  ProbeField field(std::make_shared<const World>(Cube{1, 1, 1}), probe_count(bricks));
  CountingObserver observer(width, kernel.stages.size());
  Arguments arguments = encoded(merge_parameters(), ProbeOptions{});
  // Also where few images fit, so that all widths are tried.
  arguments.set("least_side_by_side", std::uint64_t{2});
  arguments.set("projection", std::string(name_of(kProjections, projection)));
  const auto execution =
      kernel.start({width, mode, arguments, field, mode == Mode::kTracing ? &observer : nullptr});
  for (const Brick& brick : bricks) execution->run(brick);
  Rendered rendered{execution->result(), field.probes()};
  if (mode == Mode::kTracing) rendered.result.counts = observer.counts();
  return rendered;
}

std::vector<Brick> bricks_of(const World& world, std::size_t step, int levels) {
  WorldOptions options;
  options.levels = levels;
  const VoxelSource source(std::shared_ptr<const World>(&world, [](const World*) {}), options);
  std::vector<Brick> bricks;
  std::uint64_t probes = 0;
  for (int segment = 0; segment < source.segment_count(); ++segment)
    source.produce(segment, [&](const Work& work) {
      Brick brick = static_cast<const Brick&>(work);
      std::vector<Probe> chosen;
      for (std::size_t i = bricks.size() % step; i < brick.probes.size(); i += step)
        chosen.push_back(brick.probes[i]);
      brick.probes = std::move(chosen);
      brick.first_probe = probes;
      probes += brick.probes.size();
      bricks.push_back(std::move(brick));
    });
  return bricks;
}

void expect_same(const Kernel& kernel, const Rendered& rendered, const Rendered& reference) {
  EXPECT_EQ(rendered.result.results_hash, reference.result.results_hash);
  const Kernel& scalar = find_kernel("voxel_rays");
  for (const CounterInfo& info : scalar.counters)
    EXPECT_EQ(rendered.counter(kernel, info.name), reference.counter(scalar, info.name))
        << info.name;
  for (std::size_t probe = 0; probe < reference.probes.size(); ++probe)
    for (std::size_t h = 0; h < kHarmonics; ++h)
      ASSERT_NEAR(rendered.probes[probe][h], reference.probes[probe][h], 1e-6)
          << "probe " << probe << ", harmonic " << h;
}

void expect_agreement(const std::vector<Brick>& bricks, SkyProjection projection,
                      const std::vector<Mode>& modes, const std::vector<int>& widths) {
  const Rendered reference =
      render(find_kernel("voxel_rays"), 1, Mode::kCounting, projection, bricks);
  std::vector<Harmonics> harmonics;
  for (const Kernel* kernel : voxel_programs())
    for (const int width : widths)
      for (const Mode mode : modes) {
        if (width > kernel->most_width) continue;
        SCOPED_TRACE(fmt::format("{}, W = {}, {}", kernel->name, width, to_string(mode)));
        const Rendered rendered = render(*kernel, width, mode, projection, bricks);
        if (mode == Mode::kUncounted)
          EXPECT_EQ(rendered.result.results_hash, reference.result.results_hash);
        else
          expect_same(*kernel, rendered, reference);
        // Sums are of integers: equal to the last bit, in any order.
        if (harmonics.empty()) harmonics = rendered.probes;
        EXPECT_EQ(rendered.probes, harmonics);
      }
}

}  // namespace lanescope::test
