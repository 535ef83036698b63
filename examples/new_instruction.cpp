// SPDX-License-Identifier: MIT
// What if the machine had an instruction for edge functions?
//
// This program defines one outside of simulator/, uses it in a small kernel, and compares what the
// kernel issues with and without it. Nothing has to be registered: an instruction is counted under
// its mnemonic from the moment a kernel issues it.
#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "simulator/instruction_set.h"

namespace isa = lanescope::isa;
using lanescope::Counts;
using lanescope::Machine;
using lanescope::Memory;
using lanescope::Mode;

/// The instruction: what one lane computes, and what describes it in tables and reports.
struct Cross {
  static constexpr lanescope::InstructionInfo kInfo{"cross", "r[i] = ax[i] * by[i] - ay[i] * bx[i]",
                                                    lanescope::InstructionClass::kArithmetic};
  static float lane(float ax, float ay, float bx, float by) { return ax * by - ay * bx; }
};
inline constexpr lanescope::Instruction<Cross> cross;

/// The same work in instructions that the machine has.
struct CrossInThree {
  template <class On, class V>
  auto operator()(On& on, const V& ax, const V& ay, const V& bx, const V& by) const {
    return isa::sub(on, isa::mul(on, ax, by), isa::mul(on, ay, bx));
  }
};

/// Tests W samples at a time against one triangle. Returns how many are inside.
template <class Vm, class CrossOp>
int count_inside(Vm& vm, Memory<const float> xs, Memory<const float> ys, const CrossOp& cross_op) {
  constexpr float kX[] = {1.0f, 30.0f, 5.0f}, kY[] = {2.0f, 8.0f, 29.0f};
  auto test = vm.site(0);
  int inside_count = 0;
  const int size = static_cast<int>(xs.size);
  for (int first = 0; first < size; first += vm.width()) {
    auto on = test.on(vm.first_n(size - first));
    const auto px = isa::load(on, xs, first);
    const auto py = isa::load(on, ys, first);
    typename Vm::Float x[3], y[3];
    lanescope::host::unroll<3>([&](auto k) {
      x[k] = isa::sub(on, kX[k], px);
      y[k] = isa::sub(on, kY[k], py);
    });
    const auto least = isa::min(
        on,
        isa::min(on, cross_op(on, x[0], y[0], x[1], y[1]), cross_op(on, x[1], y[1], x[2], y[2])),
        cross_op(on, x[2], y[2], x[0], y[0]));
    inside_count += isa::count(on, isa::cmp_gt(on, least, 0.0f));
  }
  return inside_count;
}

void print(std::string_view title, int inside, const Counts& counts) {
  const auto total = counts.stages[0].total();
  fmt::print("{}: {} samples inside, {} instructions, {:.1f}% of {} lanes busy\n", title, inside,
             total.issued,
             100.0 * static_cast<double>(total.active) /
                 static_cast<double>(total.issued * static_cast<std::uint64_t>(counts.width)),
             counts.width);
  for (const auto& kind : counts.stages[0].instructions)
    fmt::print("  {:<8}{:>6} issued {:>6} active lanes   {}\n", kind.info->mnemonic, kind.issued,
               kind.active, kind.info->meaning);
}

int main() {
  std::vector<float> xs, ys;
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      xs.push_back(static_cast<float>(x) + 0.5f);
      ys.push_back(static_cast<float>(y) + 0.5f);
    }
  }
  const auto x = lanescope::read_only(xs.data(), xs.size(), "xs");
  const auto y = lanescope::read_only(ys.data(), ys.size(), "ys");

  Machine<16, Mode::kCounting> before(16, 1), after(16, 1);
  const int inside_before = count_inside(before, x, y, CrossInThree{});
  const int inside_after = count_inside(after, x, y, cross);
  print("without cross", inside_before, before.counts());
  print("with cross", inside_after, after.counts());
  return inside_before == inside_after ? 0 : 1;
}
