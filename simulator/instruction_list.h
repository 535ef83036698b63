// SPDX-License-Identifier: MIT
// The list of the instruction set: a row here, and a struct of that name in instructions/, make an
// instruction. Its place in the list is where blocks count it.
#pragma once

#include <cstddef>
#include <type_traits>

namespace lanescope {

template <class... Ops>
struct InstructionList {
  static constexpr std::size_t kSize = sizeof...(Ops);
};

namespace isa {

using InstructionSet = InstructionList<
    struct Add, struct Sub, struct Mul, struct Div, struct Fma, struct Neg, struct Abs, struct Min,
    struct Max, struct Sqrt, struct Rcp, struct Floor, struct Ceil,
    //
    struct BitAnd, struct BitOr, struct BitXor, struct BitAndnot, struct BitNot, struct Shl,
    struct Shr, struct Rotl, struct Popcount, struct Clz, struct Ctz,
    //
    struct CmpEq, struct CmpNe, struct CmpLt, struct CmpLe, struct CmpGt, struct CmpGe,
    //
    struct ConvertToFloat, struct ConvertToInt, struct ConvertToUint, struct BitsToUint,
    struct BitsToFloat, struct Broadcast, struct LaneIndex, struct Select, struct Move,
    //
    struct MaskAnd, struct MaskOr, struct MaskXor, struct MaskAndnot, struct MaskNot, struct Any,
    struct All, struct None, struct Count, struct First,
    //
    struct Load, struct Store, struct Gather, struct Scatter, struct LoadPair, struct GatherPair,
    struct ScatterPair, struct ScatterMin, struct ScatterMax, struct ScatterAdd, struct ScatterOr,
    //
    struct PrefixSum, struct InclusiveScan, struct ExclusiveScan, struct Compress, struct Expand,
    struct Permute, struct ShuffleUp, struct ShuffleDown, struct Conflict,
    //
    struct Hmax, struct Hmin, struct Hadd, struct Hand, struct Hor>;

}  // namespace isa

using isa::InstructionSet;

namespace detail {

template <class Op, class... Ops>
constexpr std::size_t index_in(InstructionList<Ops...>) {
  std::size_t index = 0;
  const bool found = ((std::is_same_v<Op, Ops> ? true : (++index, false)) || ...);
  return found ? index : sizeof...(Ops);
}

}  // namespace detail

/// Place of Op in the instruction set, or InstructionSet::kSize if it was defined elsewhere.
template <class Op>
inline constexpr std::size_t kInstructionIndex = detail::index_in<Op>(InstructionSet{});

}  // namespace lanescope
