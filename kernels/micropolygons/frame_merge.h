// SPDX-License-Identifier: MIT
// Frame access of *Process*: serialized, as in the thesis (3.2.1), and expressed as an instruction
// of the kernels' own. Conflicts, which a parallel frame would have to resolve, are counted.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame.h"
#include "simulator/instruction_set.h"

namespace lanescope {

/// A set of samples in a few bits, which may take a sample for another one.
template <int L>
class SampleFilter {
 public:
  /// Adds a sample. Whether it may have been there before.
  LANESCOPE_INLINE bool insert(std::uint32_t sample) {
    const std::uint32_t hash = sample * 0x9e3779b1u >> (32 - kHashBits);
    std::uint64_t& word = words_[hash / 64];
    const std::uint64_t bit = std::uint64_t{1} << hash % 64;
    const bool maybe = (word & bit) != 0;
    word |= bit;
    return maybe;
  }

 private:
  static constexpr std::uint32_t kWords = L > 16 ? L / 16 : 1;
  static constexpr int kHashBits = std::bit_width(64 * kWords) - 1;
  std::array<std::uint64_t, kWords> words_{};
};

/// Whether an active lane before `lane` has its sample, too. Not inlined: rarely asked.
template <int L>
[[gnu::noinline]] bool is_conflict(Mask<L> active, const Vec<std::int32_t, L>& sample, int lane) {
  const auto wanted = host::broadcast<typename Vec<std::int32_t, L>::Chunk>(sample[lane]);
  const auto equal = Mask<L>::of_chunks([&](auto c) LANESCOPE_INLINE_LAMBDA {
    return host::compare<host::Relation::kEqual>(sample.chunk[c], wanted);
  });
  return (equal & active & Mask<L>::first_n(lane)).any();
}

/// Where hits go: the frame, the hash of the list of hits and, if counted, counters.
template <bool kCounted>
class HitSink {
 public:
  HitSink(Frame& frame, RasterizerCounts& counts) : frame_(frame), counts_(counts) {}

  const Frame& frame() const { return frame_; }
  std::uint64_t hits_hash() const { return hits_hash_; }

  /// Takes the hits of one invocation: in each active lane i a sample with depth and colour, of the
  /// micropolygon id_of(i). If kObserved, counts them as observe() does.
  template <bool kObserved, int L, class IdOf>
  LANESCOPE_INLINE void take(Mask<L> active, IdOf&& id_of, const Vec<std::int32_t, L>& sample,
                             const Vec<float, L>& depth, const Vec<std::int32_t, L>& colour) {
    const auto samples = sample.lanes();
    const auto depths = depth.lanes();
    const auto colours = colour.lanes();
    [[maybe_unused]] ConflictSearch<L> search{active, sample};
    for_each_lane(active, [&](int lane) LANESCOPE_INLINE_LAMBDA {
      const auto i = static_cast<std::size_t>(lane);
      const auto at = static_cast<std::uint32_t>(samples[i]);
      hits_hash_ += hit_hash(id_of(i), at);
      frame_.merge(at, depths[i], static_cast<std::uint32_t>(colours[i]));
      if constexpr (kObserved && kCounted) search.look(lane, at);
    });
    if constexpr (kObserved && kCounted) count(active, search.conflicts);
  }

  /// Counts the hits of one invocation, whatever parts they are taken in.
  template <int L>
  void observe(Mask<L> active, const Vec<std::int32_t, L>& sample) {
    if constexpr (kCounted) {
      ConflictSearch<L> search{active, sample};
      for_each_lane(active,
                    [&](int lane) { search.look(lane, static_cast<std::uint32_t>(sample[lane])); });
      count(active, search.conflicts);
    }
  }

 private:
  /// Looks for lanes whose sample an earlier one has.
  template <int L>
  struct ConflictSearch {
    Mask<L> active;
    const Vec<std::int32_t, L>& sample;
    SampleFilter<L> seen{};
    std::uint64_t conflicts = 0;

    LANESCOPE_INLINE void look(int lane, std::uint32_t at) {
      if (seen.insert(at)) [[unlikely]]
        conflicts += is_conflict(active, sample, lane);
    }
  };

  template <int L>
  LANESCOPE_INLINE void count(Mask<L> active, std::uint64_t conflicts) {
    counts_[kHits] += static_cast<std::uint64_t>(active.count());
    counts_[kProcessIssued] += 1;
    if (conflicts != 0) [[unlikely]] {
      counts_[kConflictInvocations] += 1;
      counts_[kConflictHits] += conflicts;
    }
  }

  Frame& frame_;
  RasterizerCounts& counts_;
  std::uint64_t hits_hash_ = 0;
};

/// Hits of micropolygons that are numbered from `first_id`.
template <class Sink>
struct Hits {
  Sink& sink;
  std::uint64_t first_id;
};
template <class Sink>
Hits(Sink&, std::uint64_t) -> Hits<Sink>;

/// The bodies of instructions by which the nearer fragment stays. Lane i holds micropolygon number
/// i, or number[i]:
///
///   (on, hits, sample, depth, red, green, blue, alpha)
///   (on, hits, number, sample, depth, red, green, blue, alpha)
///
/// kObserved: whether an execution is an invocation of *Process*, and counted as such.
template <bool kObserved>
struct FrameUpdate {
  template <int L, class Sink, class... Channels>
  LANESCOPE_INLINE static void apply(Mask<L> active, Hits<Sink> hits,
                                     const Vec<std::int32_t, L>& sample, const Vec<float, L>& depth,
                                     const Channels&... channels) {
    hits.sink.template take<kObserved>(
        active, [&](std::size_t i) { return hits.first_id + i; }, sample, depth,
        packed<L>(channels...));
  }
  template <int L, class Sink, class... Channels>
  LANESCOPE_INLINE static void apply(Mask<L> active, Hits<Sink> hits,
                                     const Vec<std::int32_t, L>& number,
                                     const Vec<std::int32_t, L>& sample, const Vec<float, L>& depth,
                                     const Channels&... channels) {
    const auto numbers = number.lanes();
    hits.sink.template take<kObserved>(
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

/// Frame access as the thesis has it; see FrameUpdate.
struct FrameMerge : FrameUpdate<true> {
  static constexpr InstructionInfo kInfo{
      "frame_merge", "depth test and colour write of sample[i], one lane after another",
      InstructionClass::kSpecial};
};
inline constexpr Instruction<FrameMerge> frame_merge;

/// The instructions that the kernels bring along.
inline constexpr const InstructionInfo* kRasterizerInstructions[] = {&FrameMerge::kInfo};

}  // namespace lanescope
