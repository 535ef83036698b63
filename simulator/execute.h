// SPDX-License-Identifier: MIT
// How an instruction is executed on plain values: from its struct to chunks of the host.
//
// The struct has a descriptor and a body of one of these forms:
//
//   static constexpr InstructionInfo kInfo{...};
//   static T lane(T a, ...)              what one lane computes; for scalars, or a template that
//                                        takes chunks of lanes as well (see host.h)
//   static bool holds(T a, T b)          what one lane decides; the result is a mask
//   template <int L> static R apply(Mask<L> active, ...)
//                                        anything else: operands are Vec, Mask, Memory or scalars
//   template <int L> static R apply(Mask<L> active, Width width, ...)
//                                        the same, for what depends on where the vector ends
//
// A scalar operand of `lane` and `holds` is the vector-scalar form of the instruction. Dead lanes
// of a result hold nothing to rely on, unless the struct says `static constexpr int kRest = n`:
// then they keep those of operands n and up (from 0), if given. What else a struct can say is in
// checks.h.
#pragma once

#include <tuple>
#include <type_traits>

#include "simulator/instruction.h"
#include "simulator/vector.h"

namespace lanescope::detail {

template <class T>
struct IsVec : std::false_type {};
template <class T, int L>
struct IsVec<Vec<T, L>> : std::true_type {};
template <class T>
inline constexpr bool kIsVec = IsVec<std::remove_cvref_t<T>>::value;

/// The element type that decides for scalar operands: that of the first vector operand.
template <class... Operands>
struct FirstElement;
template <class First, class... Rest>
struct FirstElement<First, Rest...> {
  using type = typename std::conditional_t<kIsVec<First>, std::type_identity<First>,
                                           FirstElement<Rest...>>::type;
};
template <>
struct FirstElement<> {
  using type = void;
};

template <class Chunk, class Operand>
LANESCOPE_INLINE auto chunk_of(const Operand& operand, int c) {
  if constexpr (kIsVec<Operand>)
    return operand.chunk[c];
  else
    return host::broadcast<Chunk>(static_cast<host::ElementOf<Chunk>>(operand));
}

/// lane() on chunks where it takes them, else lane by lane.
template <class Op, class... Chunks>
LANESCOPE_INLINE auto apply_lanes(Chunks... chunks) {
  if constexpr (requires { Op::lane(chunks...); }) {
    return Op::lane(chunks...);
  } else {
    using R = decltype(Op::lane(chunks[0]...));
    using First = std::tuple_element_t<0, std::tuple<Chunks...>>;
    return host::map<host::Rebind<First, R>>([](auto... lanes) { return Op::lane(lanes...); },
                                             chunks...);
  }
}

/// decide() on chunks where there is one, else holds() lane by lane.
template <class Op, class Chunk>
LANESCOPE_INLINE host::MaskOf<Chunk> decide_lanes(Chunk a, Chunk b) {
  if constexpr (requires { Op::decide(a, b); }) {
    return Op::decide(a, b);
  } else {
    unsigned bits = 0;
    for (int i = 0; i < host::kLanes<Chunk>; ++i)
      bits |= static_cast<unsigned>(Op::holds(a[i], b[i])) << i;
    return host::mask_of_bits<host::kLanes<Chunk>>(bits);
  }
}

template <class Op, int L, class... Operands>
LANESCOPE_INLINE auto execute_in_line([[maybe_unused]] Mask<L> active, [[maybe_unused]] Width width,
                                      const Operands&... operands) {
  if constexpr (requires { Op::apply(active, operands...); }) {
    return Op::apply(active, operands...);
  } else if constexpr (requires { Op::apply(active, width, operands...); }) {
    return Op::apply(active, width, operands...);
  } else {
    using First = typename FirstElement<Operands...>::type;
    static_assert(!std::is_void_v<First>,
                  "the instruction does not take these operands, or none of them is a vector");
    using Chunk = typename First::Chunk;
    if constexpr (requires(host::ElementOf<Chunk> s) { Op::holds(s, s); }) {
      return active & Mask<L>::of_chunks([&](auto c) LANESCOPE_INLINE_LAMBDA {
               return decide_lanes<Op>(chunk_of<Chunk>(operands, c)...);
             });
    } else {
      using R = decltype(apply_lanes<Op>(chunk_of<Chunk>(operands, 0)...));
      Vec<host::ElementOf<R>, L> result;
      host::unroll<kChunks<L>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        result.chunk[c] = apply_lanes<Op>(chunk_of<Chunk>(operands, c)...);
      });
      return result;
    }
  }
}

/// How operands are passed to a call: vectors where they are, others in registers.
template <class T>
using Passed = std::conditional_t<sizeof(T) <= sizeof(std::uint64_t), const T, const T&>;

template <class Op, int L, class... Operands>
[[gnu::noinline]] auto execute_by_call(Mask<L> active, Width width, Passed<Operands>... operands) {
  return execute_in_line<Op, L>(active, width, operands...);
}

/// Executes an instruction on plain values. Requires that no lane from `width` on is active.
template <class Op, int L, class... Operands>
LANESCOPE_INLINE auto execute(Mask<L> active, Width width, const Operands&... operands) {
  if constexpr (kInRegisters<L>)
    return execute_in_line<Op, L>(active, width, operands...);
  else
    return execute_by_call<Op, L, Operands...>(active, width, operands...);
}

}  // namespace lanescope::detail
