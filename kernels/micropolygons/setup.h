// SPDX-License-Identifier: MIT
// *Setup*: batches of W micropolygons, with those that face away or have no area masked out.
#pragma once

#include <optional>
#include <vector>

#include "kernels/micropolygons/stages.h"

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

  /// Turns around those of its first `size` micropolygons that face away.
  void turn(Vm& vm, std::size_t stage, int size) {
    auto looking = vm.site(stage);
    auto swapping = vm.site(stage);
    for (int first = 0; first < size; first += vm.width()) {
      typename Vm::Lanes back;
      {
        auto on = looking.on(vm.first_n(size - first));
        back = cmp_lt(on, doubled_area<Vm, P>(on, load_positions<Vm>(on, memory(), first)), 0.0f);
        if (!any(on, back)) continue;
      }
      auto on = swapping.on(back);
      host::unroll<kAttributeCount>([&](auto a) LANESCOPE_INLINE_LAMBDA {
        const auto one = array(1, a);
        const auto other = array(kCorners<P> - 1, a);
        const auto value = load(on, one, first);
        store(on, one, first, load(on, other, first));
        store(on, other, first, value);
      });
    }
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

// What follows is bookkeeping of the host, not instructions of the machine.

/// Counts what *Setup* decided about a batch.
template <class Vm, Micropolygon P>
LANESCOPE_INLINE void count_batch(RasterizerCounts& counts, const Batch<Vm, P>& batch,
                                  typename Vm::Lanes valid) {
  using Chunk = typename Vec<float, Vm::kLanes>::Chunk;
  const auto& area = Vm::look(batch.area);
  const auto away = Vm::Lanes::of_chunks([&](auto c) LANESCOPE_INLINE_LAMBDA {
    return host::compare<host::Relation::kLess>(area.chunk[c], Chunk{});
  });
  const auto seen = static_cast<std::uint64_t>(valid.count());
  const auto alive = static_cast<std::uint64_t>(batch.alive.count());
  const auto culled = static_cast<std::uint64_t>((away & valid).count());
  counts[kSeen] += seen;
  counts[kRasterized] += alive;
  counts[kCulled] += culled;
  counts[kDegenerate] += seen - alive - culled;
}

/// Counts what *Bound* decided about a batch; `with_candidates` are the lanes that have some.
template <class Vm>
LANESCOPE_INLINE void count_boxes(RasterizerCounts& counts, const Box<Vm>& box,
                                  typename Vm::Lanes alive, typename Vm::Lanes with_candidates) {
  using Chunk = typename Vec<std::int32_t, Vm::kLanes>::Chunk;
  const auto& candidates = Vm::look(box.candidates);
  // A frame has at most 2^28 samples, so that eight boxes add up in 32 bits.
  constexpr int kAddedUp = 8;
  std::uint64_t tests = 0;
  for (int first = 0; first < kChunks<Vm::kLanes>; first += kAddedUp) {
    Chunk sums{};
    for (int c = first; c < first + kAddedUp && c < kChunks<Vm::kLanes>; ++c)
      sums += host::blend(with_candidates.chunk(c), candidates.chunk[c], Chunk{});
    for (int i = 0; i < host::kLanes<Chunk>; ++i) tests += static_cast<std::uint32_t>(sums[i]);
  }
  counts[kTests] += tests;
  counts[kOffScreen] += static_cast<std::uint64_t>(alive.count() - with_candidates.count());
}

}  // namespace lanescope
