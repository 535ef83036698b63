// SPDX-License-Identifier: MIT
// An instruction of the voxel programs.
#pragma once

#include "simulator/instruction_set.h"

namespace lanescope {

/// or_into(on, a, b, rest): the one merging form of arithmetic that these programs need. Vector
/// ISAs whose masks merge (AVX-512, SVE, RVV with mask undisturbed) have it; without it, each would
/// be a `bit_or` and a `move`.
struct OrInto {
  static constexpr InstructionInfo kInfo{
      "or_into", "r[i] = a[i] | b[i]; lanes that are off keep rest[i]", InstructionClass::kInteger};
  static constexpr int kRest = 2;
  template <int W, class B>
  LANESCOPE_INLINE static Vec<std::int32_t, W> apply(Mask<W> active, const Vec<std::int32_t, W>& a,
                                                     const B& b, const Vec<std::int32_t, W>& rest) {
    using Chunk = typename Vec<std::int32_t, W>::Chunk;
    Vec<std::int32_t, W> r;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      r.chunk[c] =
          host::blend(active.chunk(c), a.chunk[c] | detail::chunk_of<Chunk>(b, c), rest.chunk[c]);
    });
    return r;
  }
};
inline constexpr Instruction<OrInto> or_into;

/// The instructions that the voxel programs bring along.
inline constexpr const InstructionInfo* kProbeInstructions[] = {&OrInto::kInfo};

}  // namespace lanescope
