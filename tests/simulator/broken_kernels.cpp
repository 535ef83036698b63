// SPDX-License-Identifier: MIT
#include "tests/simulator/broken_kernels.h"

#include <algorithm>
#include <array>

namespace lanescope::test {
namespace {

using namespace isa;
using Vm = SlowMachine<8>;
using Lanes = Mask<8>;

/// Eight elements, 0 to 7, in the middle of more: where a kernel leaves them there is memory, so
/// that it runs to its end when nobody looks.
template <class T>
class Row {
 public:
  Row() {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      elements_[i] = static_cast<T>(static_cast<int>(i) - 8);
  }
  Memory<T> memory() { return {elements_.data() + 8, 8, "row", nullptr}; }

 private:
  std::array<T, 24> elements_;
};

/// What a kernel has computed of the lanes that it kept is used in all of them.
void dead_lane(Vm& vm) {
  auto site = vm.site(0);
  Vm::Float depth;
  {
    auto on = site.on(vm.first_n(3));
    depth = broadcast(on, 0.5f);
  }
  auto on = site.on(vm.all());
  mul(on, depth, 2.0f);  // wrong
}

void stale_mask(Vm& vm) {
  auto site = vm.site(0);
  Row<float> row;
  const Lanes before_culling = vm.all();
  Lanes alive;
  {
    auto on = site.on(before_culling);
    alive = cmp_lt(on, lane_index(on), 5);
  }
  Vm::Float shade;
  {
    auto on = site.on(alive);
    shade = broadcast(on, 1.0f);
  }
  auto on = site.on(before_culling);
  store(on, row.memory(), 0, shade);  // wrong
}

void compressed_tail(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto lanes = lane_index(on);
  const auto packed = compress(on, cmp_gt(on, lanes, 3), lanes);
  hadd(on, packed);  // wrong
}

void complement(Vm& vm) {
  auto site = vm.site(0);
  const Lanes done = vm.first_n(2);
  auto on = site.on(~done);  // wrong
  add(on, lane_index(on), 1);
}

void last_batch(Vm& vm) {
  auto site = vm.site(0);
  Row<float> row;
  for (int first = 0; first < 8; first += vm.width()) {
    auto on = site.on(vm.all());
    load(on, row.memory(), first);  // wrong
  }
}

void neighbour(Vm& vm) {
  auto site = vm.site(0);
  Row<float> row;
  auto on = site.on(vm.all());
  gather(on, row.memory(), add(on, lane_index(on), 1));  // wrong
}

void off_screen(Vm& vm) {
  auto site = vm.site(0);
  Row<float> row;
  auto on = site.on(vm.all());
  const auto column = sub(on, lane_index(on), 2);
  scatter(on, row.memory(), column, broadcast(on, 1.0f));  // wrong
}

void histogram(Vm& vm) {
  auto site = vm.site(0);
  Row<std::int32_t> row;
  auto on = site.on(vm.all());
  const auto bin = shr(on, lane_index(on), 1);
  const auto count = gather(on, row.memory(), bin);
  scatter(on, row.memory(), bin, add(on, count, 1));  // wrong
}

void records_overlap(Vm& vm) {
  auto site = vm.site(0);
  Row<std::int32_t> row;
  auto on = site.on(vm.first_n(4));
  const auto lanes = lane_index(on);
  scatter_pair(on, row.memory(), bit_and(on, lanes, 2), lanes, lanes);  // wrong
}

void queue_tail(Vm& vm) {
  auto site = vm.site(0);
  Buffer<std::int32_t> queue(8, "queue", vm.checks());
  {
    auto on = site.on(vm.first_n(3));
    store(on, queue.memory(), 0, lane_index(on));
  }
  auto on = site.on(vm.all());
  load(on, queue.memory(), 0);  // wrong
}

void not_cleared(Vm& vm) {
  auto site = vm.site(0);
  Buffer<std::int32_t> counts(8, "counts", vm.checks());
  auto on = site.on(vm.all());
  scatter_add(on, counts.memory(), lane_index(on), broadcast(on, 1));  // wrong
}

void bit_of_sample(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto sample = add(on, lane_index(on), 28);
  shl(on, 1, sample);  // wrong
}

void far_away(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto x = mul(on, convert_to_float(on, lane_index(on)), 1e9f);
  convert_to_int(on, x);  // wrong
}

void left_of_zero(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto x = sub(on, convert_to_float(on, lane_index(on)), 3.0f);
  convert_to_uint(on, x);  // wrong
}

void mean_of_none(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto hits = lane_index(on);
  div(on, mul(on, hits, 3), hits);  // wrong
}

void normalized(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto length = convert_to_float(on, lane_index(on));
  mul(on, length, rcp(on, length));  // wrong
}

void infinite_sum(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.first_n(2));
  const auto lanes = convert_to_float(on, lane_index(on));
  const auto infinities = rcp(on, select(on, cmp_eq(on, lanes, 0.0f), 0.0f, broadcast(on, -0.0f)));
  hadd(on, infinities);  // wrong
}

void nearest_of_none(Vm& vm) {
  auto site = vm.site(0);
  Lanes hit;
  Vm::Float depth;
  {
    auto on = site.on(vm.all());
    depth = convert_to_float(on, lane_index(on));
    hit = cmp_gt(on, depth, 100.0f);
  }
  auto on = site.on(hit);
  hmin(on, depth);  // wrong
}

void next_lane(Vm& vm) {
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto lanes = lane_index(on);
  permute(on, lanes, add(on, lanes, 1));  // wrong
}

constexpr BrokenKernel kBroken[] = {
    {"dead_lane", "what three lanes have computed is used in eight", Check::kDeadLane,
     "mul, lane 3: operand 1 is read, but the lane was off when it was computed", 8, dead_lane},
    {"stale_mask", "lanes that have been culled store with the others", Check::kDeadLane,
     "store, lane 5: operand 3 is read, but the lane was off when it was computed", 8, stale_mask},
    {"compressed_tail", "the lanes behind those that `compress` has moved to the front are added",
     Check::kDeadLane, "hadd, lane 4: operand 1 is read, but the lane was off when it was computed",
     8, compressed_tail},
    {"complement", "the complement of a mask has lanes from W on, of a machine that has more",
     Check::kBeyondWidth, "a block has lane 7 on, of a machine that is 5 wide", 5, complement},
    {"last_batch", "the last batch is shorter than the vector that is loaded", Check::kBounds,
     "load, lane 3: element 8 is outside 'row', which has 8", 5, last_batch},
    {"neighbour", "the last column has no neighbour to the right", Check::kBounds,
     "gather, lane 7: element 8 is outside 'row', which has 8", 8, neighbour},
    {"off_screen", "columns to the left of the screen are stored to", Check::kBounds,
     "scatter, lane 0: element -2 is outside 'row', which has 8", 8, off_screen},
    {"histogram", "lanes with one bin all store the old count plus one", Check::kConflict,
     "scatter, lanes 0 and 1: both store to element 0 of 'row', in one instruction", 8, histogram},
    {"records_overlap", "two lanes have one record", Check::kConflict,
     "scatter_pair, lanes 0 and 1: both store to element 0 of 'row', in one instruction", 8,
     records_overlap},
    {"queue_tail", "three entries are in the queue, and eight are taken", Check::kUnwritten,
     "load, lane 3: element 3 of 'queue' is read, but was never written", 8, queue_tail},
    {"not_cleared", "counts are added to before they are set to 0", Check::kUnwritten,
     "scatter_add, lane 0: element 0 of 'counts' is read, but was never written", 8, not_cleared},
    {"bit_of_sample", "a word has no bit for sample 32 and up", Check::kShiftCount,
     "shl, lane 4: the count is not from 0 to 31, in shl(1, 32)", 8, bit_of_sample},
    {"far_away", "a coordinate is beyond what an integer holds", Check::kConversion,
     "convert_to_int, lane 3: the value is out of range, in convert_to_int(3000000000)", 8,
     far_away},
    {"left_of_zero", "a negative coordinate becomes an unsigned integer", Check::kConversion,
     "convert_to_uint, lane 0: the value is out of range, in convert_to_uint(-3)", 8, left_of_zero},
    {"mean_of_none", "a lane without hits divides by their number", Check::kDivision,
     "div, lane 0: the divisor is 0, or int32 does not hold the quotient, in div(0, 0)", 8,
     mean_of_none},
    {"normalized", "a vector of length 0 is normalized", Check::kNan,
     "mul, lane 0: the result is not a number, in mul(0, inf)", 8, normalized},
    {"infinite_sum", "infinities of both signs are added", Check::kNan,
     "hadd, all lanes: the result is not a number", 8, infinite_sum},
    {"nearest_of_none", "the nearest hit is asked for where nothing was hit", Check::kNoLane,
     "hmin, all lanes: no lane is active", 8, nearest_of_none},
    {"next_lane", "the last lane has no next one, and takes the first", Check::kLaneIndex,
     "permute, lane 7: the index is not from 0 to W - 1, in permute(7, 8)", 8, next_lane},
};

constexpr std::array<std::int32_t, 12> kHeights{5, 3, 8, 1, 9, 2, 2, 7, 4, 6, 0, 3};

/// How many heights rise above all before them. Returns it for the maxima that `before` carries.
std::int32_t count_visible(Vm& vm, bool carries) {
  auto site = vm.site(0);
  const auto heights = read_only(kHeights.data(), kHeights.size(), "heights");
  std::int32_t visible = 0, highest = -1;
  const int size = static_cast<int>(kHeights.size());
  for (int first = 0; first < size; first += vm.width()) {
    auto on = site.on(vm.first_n(size - first));
    const auto height = load(on, heights, first);
    auto before = broadcast(on, carries ? highest : -1);
    for (int lane = 0; lane + 1 < vm.width(); ++lane) {
      const auto left = shuffle_up(on, max(on, before, height), 1);
      before = select(on, cmp_gt(on, lane_index(on), 0), max(on, before, left), before);
    }
    visible += count(on, cmp_gt(on, height, before));
    highest = std::max(highest, hmax(on, height));
  }
  return visible;
}

constexpr WidthDependence kWidthDependence{
    "visible_heights", "what lies before the batch is forgotten, so that each begins anew",
    "visible_heights on heights: its results at W = 2 are not those at W = 1",
    [](Vm& vm) { return count_visible(vm, false); },
    [](Vm& vm) { return count_visible(vm, true); }};

}  // namespace

std::span<const BrokenKernel> broken_kernels() { return kBroken; }

const WidthDependence& width_dependence() { return kWidthDependence; }

}  // namespace lanescope::test
