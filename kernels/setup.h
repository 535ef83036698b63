// SPDX-License-Identifier: MIT
// *Setup*: batches of W micropolygons, with those that face away or have no area masked out.
#pragma once

#include <optional>
#include <vector>

#include "kernels/stages.h"

namespace lanescope {

/// A batch of consecutive micropolygons after *Setup*.
template <class Vm, Micropolygon P>
struct Batch {
  typename Vm::Lanes alive;  ///< Those that face the viewer.
  bool any_alive;
  Positions<Vm, P> positions;
  typename Vm::Float area;  ///< Doubled.
};

/// A copy of a packet in which micropolygons that face away are turned around, for runs without
/// culling: two of their corners are swapped, so that all that follows sees positive areas.
template <class Vm, Micropolygon P>
class TurnedPacket {
 public:
  TurnedPacket(const Packet& packet, bool checked)
      : size_(static_cast<std::size_t>(packet.padded_capacity())),
        copy_(size_ * kCorners<P> * kAttributeCount, "turned packet", checked) {
    for (int k = 0; k < kCorners<P>; ++k)
      for (int a = 0; a < kAttributeCount; ++a)
        copy_.fill(offset(k, a), packet.values(k, static_cast<Attribute>(a)), size_);
  }

  /// Turns around the micropolygons `first` ... in the lanes of `valid`.
  void turn(Vm& vm, std::size_t stage, std::int64_t first, typename Vm::Lanes valid) {
    auto look = vm.site(stage);
    auto swap = vm.site(stage);
    typename Vm::Lanes back;
    {
      auto on = look.on(valid);
      back = cmp_lt(on, doubled_area<Vm, P>(on, load_positions<Vm>(on, memory(), first)), 0.0f);
      if (!any(on, back)) return;
    }
    auto on = swap.on(back);
    host::unroll<kAttributeCount>([&](auto a) LANESCOPE_INLINE_LAMBDA {
      const auto one = array(1, a);
      const auto other = array(kCorners<P> - 1, a);
      const auto value = load(on, one, first);
      store(on, one, first, load(on, other, first));
      store(on, other, first, value);
    });
  }

  PacketMemory<P> memory() {
    PacketMemory<P> m;
    for (int k = 0; k < kCorners<P>; ++k)
      for (int a = 0; a < kAttributeCount; ++a) m.attributes[k][a] = array(k, a);
    return m;
  }

 private:
  std::size_t offset(int corner, int attribute) const {
    return static_cast<std::size_t>(corner * kAttributeCount + attribute) * size_;
  }
  Memory<float> array(int corner, int attribute) {
    return copy_.memory().part(offset(corner, attribute), size_);
  }

  std::size_t size_;
  Buffer<float> copy_;
};

/// Loads and culls the batch that starts at `first`; `valid` are its lanes that hold one.
template <class Vm, Micropolygon P, class SetupSite>
LANESCOPE_INLINE Batch<Vm, P> set_up(SetupSite& site, const PacketMemory<P>& packet,
                                     std::int64_t first, typename Vm::Lanes valid) {
  Batch<Vm, P> batch;
  auto on = site.on(valid);
  batch.positions = load_positions<Vm>(on, packet, first);
  batch.area = doubled_area<Vm, P>(on, batch.positions);
  batch.alive = cmp_gt(on, batch.area, 0.0f);
  batch.any_alive = any(on, batch.alive);
  return batch;
}

/// Number of the lanes in which the vector satisfies a predicate: bookkeeping, not an instruction.
template <int W, class V, class F>
std::uint64_t count_lanes(Mask<W> lanes, const V& vec, F&& predicate) {
  std::uint64_t count = 0;
  const auto values = detail::plain(vec).lanes();
  for_each_lane(lanes, [&](int i) { count += predicate(values[static_cast<std::size_t>(i)]); });
  return count;
}

/// Counts what *Setup* decided about a batch.
template <class Vm, Micropolygon P>
void count_batch(RasterizerCounts& counts, const Batch<Vm, P>& batch, typename Vm::Lanes valid) {
  const auto seen = static_cast<std::uint64_t>(valid.count());
  const auto alive = static_cast<std::uint64_t>(batch.alive.count());
  const std::uint64_t culled =
      count_lanes(valid & ~batch.alive, batch.area, [](float area) { return area < 0.0f; });
  counts[kSeen] += seen;
  counts[kRasterized] += alive;
  counts[kCulled] += culled;
  counts[kDegenerate] += seen - alive - culled;
}

/// Counts what *Bound* decided about a batch.
template <class Vm>
void count_boxes(RasterizerCounts& counts, const Box<Vm>& box, typename Vm::Lanes alive) {
  const auto candidates = detail::plain(box.candidates).lanes();
  for_each_lane(alive, [&](int i) {
    const auto n = static_cast<std::uint64_t>(candidates[static_cast<std::size_t>(i)]);
    counts[kTests] += n;
    counts[kOffScreen] += n == 0;
  });
}

}  // namespace lanescope
