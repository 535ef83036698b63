// SPDX-License-Identifier: MIT
// What counting costs: W1 by hand, uncounted and counting, and the kernels uncounted and counting,
// in turn within one process; prints the median of the ratios of each round.
#include <fmt/format.h>

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "benchmarks/w1.h"
#include "kernels/kernel.h"

namespace lanescope {
namespace {

constexpr int kRounds = 15;

/// Processor time of this thread: other processes on a shared machine do not count.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class F>
double seconds(F&& work) {
  const double start = thread_seconds();
  work();
  return thread_seconds() - start;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// Median of time(a) / time(b) over rounds in which they take turns.
template <class A, class B>
double ratio(A&& a, B&& b) {
  std::vector<double> ratios;
  for (int round = 0; round < kRounds; ++round) {
    const double one = seconds(a);
    ratios.push_back(one / seconds(b));
  }
  return median(ratios);
}

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

/// A sheet of half-pixel triangles, turned and sheared so that boxes differ, over part of a frame.
std::vector<Packet> make_packets() {
  std::vector<Packet> packets;
  for (int p = 0; p < 64; ++p) {
    Packet packet(Micropolygon::kTriangle, 1920);
    for (int i = 0; i < 1920; ++i) {
      const float u = static_cast<float>(i / 2 % 31), v = static_cast<float>(i / 2 / 31);
      const auto corner = [&](float du, float dv) {
        const float a = u + du, b = v + dv;
        const float bend = 1 + 0.3f * std::sin(0.3f * a + 0.2f * b + static_cast<float>(p));
        Vertex vertex{{60.0f * static_cast<float>(p % 8) + 10 + 1.5f * a * bend + 0.3f * b,
                       60.0f * static_cast<float>(p / 8) + 10 + 1.5f * b - 0.2f * a * bend, 1.0f + 0.01f * a,
                       0.5f, 0.4f, 0.3f, 1.0f}};
        for (const Attribute axis : {Attribute::kX, Attribute::kY})
          vertex[axis] = std::round(vertex[axis] / kSubpixel) * kSubpixel;
        return vertex;
      };
      const Vertex a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      const Vertex corners[2][3] = {{a, b, c}, {a, c, d}};
      packet.append(corners[i % 2]);
    }
    packets.push_back(std::move(packet));
  }
  return packets;
}

void measure_kernel(const Kernel& kernel, int width, const std::vector<Packet>& packets) {
  const SampleGrid grid(320, 320, 4, true, 1);
  Frame frame(grid);
  const auto run = [&](Mode mode) {
    return [&, execution = kernel.start(width, mode, {}, frame)]() mutable {
      for (const Packet& packet : packets) execution->rasterize(packet);
    };
  };
  fmt::print("{:<9} {:>3} {:>22.3f}\n", kernel.name, width,
             ratio(run(Mode::kCounting), run(Mode::kUncounted)));
}

}  // namespace
}  // namespace lanescope

int main() {
  using namespace lanescope;
  fmt::print("Medians of {} rounds\n\nwork        W   counting / uncounted   uncounted / by hand\n",
             kRounds);
  w1::Triangles triangles = w1::make_triangles(1 << 20);
  measure_w1<16>(triangles);
  measure_w1<32>(triangles);
  measure_w1<64>(triangles);
  const auto packets = make_packets();
  for (const char* name : {"lockstep", "repack"})
    for (const int width : {16, 32, 64}) measure_kernel(find_kernel(name), width, packets);
  return EXIT_SUCCESS;
}
