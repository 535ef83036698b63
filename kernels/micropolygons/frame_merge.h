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

/// Where hits go: the frame, the hash of the list of hits, and counters.
struct HitSink {
  Frame* frame;
  bool counting;
  RasterizerCounts* counts;
  std::uint64_t hits_hash = 0;
  /// Ids of the micropolygons in the lanes; set before FrameMerge is issued.
  std::array<std::uint64_t, 64> ids{};

  void hit(std::uint64_t id, std::uint32_t sample, float depth, std::uint32_t colour) {
    hits_hash += hit_hash(id, sample);
    frame->merge(sample, depth, colour);
  }
};

/// frame_merge(on, sink, sample, depth, red, green, blue, alpha): the nearer fragment stays.
struct FrameMerge {
  static constexpr InstructionInfo kInfo{
      "frame_merge", "depth test and colour write of sample[i], one lane after another",
      InstructionClass::kSpecial};

  template <int W>
  static void apply(Mask<W> active, HitSink* sink, const Vec<std::int32_t, W>& sample,
                    const Vec<float, W>& depth, const Vec<float, W>& red,
                    const Vec<float, W>& green, const Vec<float, W>& blue,
                    const Vec<float, W>& alpha) {
    const auto samples = sample.lanes();
    const auto depths = depth.lanes();
    const auto colours = packed(red, green, blue, alpha).lanes();
    for_each_lane(active, [&](int lane) LANESCOPE_INLINE_LAMBDA {
      const auto i = static_cast<std::size_t>(lane);
      sink->hit(sink->ids[i], static_cast<std::uint32_t>(samples[i]), depths[i],
                static_cast<std::uint32_t>(colours[i]));
    });
    if (sink->counting) count(active, *sink->counts, sample);
  }
  template <int W, class F, class... Shades>
  static void touch(Mask<W> active, F&& f, HitSink* sink, const Vec<std::int32_t, W>& sample,
                    const Shades&...) {
    const auto& samples = sink->frame->samples();
    const auto frame = read_only(samples.data(), samples.size(), "frame");
    for_each_lane(active, [&](int i) { f(i, frame, std::int64_t{sample[i]}, true); });
  }

 private:
  template <int W>
  LANESCOPE_INLINE static Vec<std::int32_t, W> packed(const Vec<float, W>& red,
                                                      const Vec<float, W>& green,
                                                      const Vec<float, W>& blue,
                                                      const Vec<float, W>& alpha) {
    Vec<std::int32_t, W> r;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      r.chunk[c] = pack_channels(red.chunk[c], green.chunk[c], blue.chunk[c], alpha.chunk[c]);
    });
    return r;
  }

  template <int W>
  LANESCOPE_INLINE static void count(Mask<W> active, RasterizerCounts& counts,
                                     const Vec<std::int32_t, W>& sample) {
    const int hits = active.count();
    const auto packed_samples = isa::Compress::apply(active, active, sample);
    const auto conflicts = static_cast<std::uint64_t>(
        isa::Conflict::apply(Mask<W>::first_n(hits), packed_samples).count());
    counts[kHits] += static_cast<std::uint64_t>(hits);
    counts[kProcessIssued] += 1;
    counts[kConflictInvocations] += conflicts != 0;
    counts[kConflictHits] += conflicts;
  }
};
inline constexpr Instruction<FrameMerge> frame_merge;

}  // namespace lanescope
