// SPDX-License-Identifier: MIT
// Frame access of *Process*: serialized, as in the thesis (3.2.1), and expressed as an instruction
// of the kernels' own. Conflicts, which a parallel frame would have to resolve, are counted.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame.h"
#include "simulator/instruction_set.h"

namespace lanescope {

/// The samples that one invocation of *Process* has hit; cleared in no time for the next one.
class SamplesHit {
 public:
  void clear() {
    if (++invocation_ == 0) *this = SamplesHit();
  }
  /// Whether the sample was hit before. Requires at most 64 hits between two clear().
  bool hit_again(std::uint32_t sample) {
    const std::uint64_t entry = std::uint64_t{invocation_} << 32 | sample;
    for (std::size_t i = sample * 0x9e3779b1u >> kShift;; i = (i + 1) % kSlots) {
      if (slots_[i] == entry) return true;
      if (slots_[i] >> 32 != invocation_) {
        slots_[i] = entry;
        return false;
      }
    }
  }

 private:
  static constexpr int kBits = 8;
  static constexpr int kShift = 32 - kBits;
  static constexpr std::size_t kSlots = std::size_t{1} << kBits;
  std::uint32_t invocation_ = 1;
  std::array<std::uint64_t, kSlots> slots_{};  ///< Invocation and sample of the last hit there.
};

/// Where hits go: the frame, the hash of the list of hits and, if counted, counters.
template <bool kCounted>
class HitSink {
 public:
  HitSink(Frame& frame, RasterizerCounts& counts) : frame_(frame), counts_(counts) {}

  const Frame& frame() const { return frame_; }
  std::uint64_t hits_hash() const { return hits_hash_; }

  /// Takes the hits of one invocation: in each active lane i a sample with depth and colour, of the
  /// micropolygon id_of(i).
  template <int L, class IdOf>
  LANESCOPE_INLINE void take(Mask<L> active, IdOf&& id_of, const Vec<std::int32_t, L>& sample,
                             const Vec<float, L>& depth, const Vec<std::int32_t, L>& colour) {
    const auto samples = sample.lanes();
    const auto depths = depth.lanes();
    const auto colours = colour.lanes();
    std::uint64_t conflicts = 0;
    if constexpr (kCounted) samples_.clear();
    for_each_lane(active, [&](int lane) LANESCOPE_INLINE_LAMBDA {
      const auto i = static_cast<std::size_t>(lane);
      const auto at = static_cast<std::uint32_t>(samples[i]);
      hits_hash_ += hit_hash(id_of(i), at);
      frame_.merge(at, depths[i], static_cast<std::uint32_t>(colours[i]));
      if constexpr (kCounted) conflicts += samples_.hit_again(at);
    });
    if constexpr (kCounted) {
      counts_[kHits] += static_cast<std::uint64_t>(active.count());
      counts_[kProcessIssued] += 1;
      counts_[kConflictInvocations] += conflicts != 0;
      counts_[kConflictHits] += conflicts;
    }
  }

 private:
  Frame& frame_;
  RasterizerCounts& counts_;
  std::uint64_t hits_hash_ = 0;
  SamplesHit samples_;
};

/// Hits of micropolygons that are numbered from `first_id`.
template <class Sink>
struct Hits {
  Sink& sink;
  std::uint64_t first_id;
};
template <class Sink>
Hits(Sink&, std::uint64_t) -> Hits<Sink>;

/// The nearer fragment stays. Lane i holds micropolygon number i, or number[i]:
///
///   frame_merge(on, hits, sample, depth, red, green, blue, alpha)
///   frame_merge(on, hits, number, sample, depth, red, green, blue, alpha)
struct FrameMerge {
  static constexpr InstructionInfo kInfo{
      "frame_merge", "depth test and colour write of sample[i], one lane after another",
      InstructionClass::kSpecial};

  template <int L, class Sink, class... Channels>
  LANESCOPE_INLINE static void apply(Mask<L> active, Hits<Sink> hits,
                                     const Vec<std::int32_t, L>& sample, const Vec<float, L>& depth,
                                     const Channels&... channels) {
    hits.sink.take(
        active, [&](std::size_t i) { return hits.first_id + i; }, sample, depth,
        packed<L>(channels...));
  }
  template <int L, class Sink, class... Channels>
  LANESCOPE_INLINE static void apply(Mask<L> active, Hits<Sink> hits,
                                     const Vec<std::int32_t, L>& number,
                                     const Vec<std::int32_t, L>& sample, const Vec<float, L>& depth,
                                     const Channels&... channels) {
    const auto numbers = number.lanes();
    hits.sink.take(
        active,
        [&](std::size_t i) { return hits.first_id + static_cast<std::uint64_t>(numbers[i]); },
        sample, depth, packed<L>(channels...));
  }

  template <int L, class F, class Sink, class... Shades>
  static void touch(Mask<L> active, F&& f, Hits<Sink> hits, const Vec<std::int32_t, L>& sample,
                    const Vec<float, L>&, const Shades&...) {
    const auto& samples = hits.sink.frame().samples();
    const auto frame = read_only(samples.data(), samples.size(), "frame");
    for_each_lane(active, [&](int i) { f(i, frame, std::int64_t{sample[i]}, Access::kUpdate); });
  }
  template <int L, class F, class Sink, class... Shades>
  static void touch(Mask<L> active, F&& f, Hits<Sink> hits, const Vec<std::int32_t, L>&,
                    const Vec<std::int32_t, L>& sample, const Shades&... shades) {
    touch(active, f, hits, sample, shades...);
  }

 private:
  template <int L>
  LANESCOPE_INLINE static Vec<std::int32_t, L> packed(const Vec<float, L>& red,
                                                      const Vec<float, L>& green,
                                                      const Vec<float, L>& blue,
                                                      const Vec<float, L>& alpha) {
    Vec<std::int32_t, L> r;
    host::unroll<kChunks<L>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      r.chunk[c] = pack_channels(red.chunk[c], green.chunk[c], blue.chunk[c], alpha.chunk[c]);
    });
    return r;
  }
};
inline constexpr Instruction<FrameMerge> frame_merge;

/// The instructions that the kernels bring along.
inline constexpr const InstructionInfo* kRasterizerInstructions[] = {&FrameMerge::kInfo};

}  // namespace lanescope
