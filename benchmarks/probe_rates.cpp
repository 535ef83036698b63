// SPDX-License-Identifier: MIT
// How many octants a millisecond the uncounted voxel programs render on one core, harmonics
// included, over how full the world is; beside the article's loop and across_cameras by hand. All
// render the same images, which is checked.
#include <fmt/format.h>

#include <cstdlib>

#include "benchmarks/probe_renderers.h"
#include "benchmarks/timing.h"
#include "kernels/kernel.h"
#include "simulator/base/random.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

using benchmarks::ByteBrick;

constexpr int kSize = 3 * kReach;  ///< A brick, and the 16 cubes around it.

/// The brick in the middle of a world that is filled at random.
Brick scattered_brick(std::uint64_t percent) {
  World world({kSize, kSize, kSize});
  world.margin = kReach + 4;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        if (mix64(static_cast<std::uint64_t>(x + kSize * (y + kSize * z))) % 100 < percent)
          world.fill({x, y, z}, 1);
  WorldOptions options;
  options.piece_probes = kMostProbes;
  const VoxelSource source(std::make_shared<const World>(std::move(world)), options);
  Brick brick;
  source.produce(0, [&](const Work& work) { brick = static_cast<const Brick&>(work); });
  return brick;
}

/// One brick, and how it is rendered in each way.
struct Bench {
  Bench(const Brick& b, SkyProjection p)
      : brick(b),
        projection(p),
        bytes(brick),
        field(std::make_shared<const World>(Cube{1, 1, 1}), brick.probes.size()),
        harmonics(brick.probes.size()) {
    arguments.set("projection", std::string(name_of(kProjections, projection)));
  }

  auto program(const char* name, int width) {
    return [this, kernel = &find_kernel(name), width] {
      const auto execution = kernel->start({width, Mode::kUncounted, arguments, field});
      execution->run(brick);
      return execution->result().results_hash;
    };
  }
  auto article() {
    return [this] { return benchmarks::article_loop(bytes, projection, harmonics); };
  }
  template <int W>
  auto by_hand() {
    return [this] { return benchmarks::cameras_by_hand<W>(brick, projection, harmonics); };
  }
  /// Octants that no cube at the corner blocks.
  double octants() {
    const auto execution =
        find_kernel("across_cameras").start({16, Mode::kCounting, arguments, field});
    execution->run(brick);
    return static_cast<double>(execution->result().counters[kOctantsRendered]);
  }

  const Brick& brick;
  SkyProjection projection;
  ByteBrick bytes;
  ProbeField field;
  std::vector<Harmonics> harmonics;
  Arguments arguments;
};

template <class Render>
double rate(Bench& bench, Render&& render) {
  return bench.octants() / (1e3 * benchmarks::median_seconds(render));
}

void print_rates(Bench& bench, std::uint64_t percent) {
  const auto article = bench.article();
  const std::uint64_t wanted = article();
  fmt::print("{:<10} {:>6}% {:>13.0f}", name_of(kProjections, bench.projection), percent,
             rate(bench, article));
  const auto show = [&](auto render) {
    if (render() != wanted) throw std::logic_error("images differ");
    fmt::print(" {:>13.0f}", rate(bench, render));
  };
  show(bench.program("across_image", bench.projection == SkyProjection::kFaces ? 24 : 8));
  for (const int width : {16, 32, 64}) show(bench.program("across_cameras", width));
  fmt::print("\n");
}

template <int W>
void print_ratio(Bench& bench, std::uint64_t percent) {
  const auto by_hand = bench.by_hand<W>();
  const auto program = bench.program("across_cameras", W);
  if (by_hand() != program()) throw std::logic_error("images differ");
  fmt::print("{:<10} {:>6}% {:>3} {:>20.3f}\n", name_of(kProjections, bench.projection), percent, W,
             benchmarks::ratio(program, by_hand));
}

}  // namespace
}  // namespace lanescope

int main() {
  using namespace lanescope;
  constexpr std::uint64_t kPercents[] = {1, 5, 20, 50};
  constexpr SkyProjection kBoth[] = {SkyProjection::kFaces, SkyProjection::kDirections};
  fmt::print(
      "Octants a millisecond, medians of {} rounds\n\n{:<10} {:>7} {:>13} {:>13} {:>13} "
      "{:>13} {:>13}\n",
      benchmarks::kRounds, "projection", "filled", "article", "across_image", "cameras 16",
      "cameras 32", "cameras 64");
  for (const SkyProjection projection : kBoth)
    for (const std::uint64_t percent : kPercents) {
      const Brick brick = scattered_brick(percent);
      Bench bench(brick, projection);
      print_rates(bench, percent);
    }
  fmt::print("\n{:<10} {:>7} {:>3} {:>20}\n", "projection", "filled", "W", "uncounted / by hand");
  for (const SkyProjection projection : kBoth)
    for (const std::uint64_t percent : kPercents) {
      const Brick brick = scattered_brick(percent);
      Bench bench(brick, projection);
      print_ratio<16>(bench, percent);
      print_ratio<32>(bench, percent);
      print_ratio<64>(bench, percent);
    }
  return EXIT_SUCCESS;
}
