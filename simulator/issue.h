// SPDX-License-Identifier: MIT
// One path through which every instruction is issued, charged and, on a checked machine, checked.
//
// An instruction is a struct with a descriptor and a body of one of these forms:
//
//   static constexpr InstructionInfo kInfo{...};
//   static T lane(T a, ...)              what one lane computes; for scalars, or a template that
//                                        takes chunks of lanes as well (see host.h)
//   static bool holds(T a, T b)          what one lane decides; the result is a mask
//   template <int W> static R apply(Mask<W> active, ...)
//                                        anything else: operands are Vec, Mask, Memory or scalars
//
// and `inline constexpr Instruction<Op> op;` makes it callable: op(block, operands...). A scalar
// operand of `lane` and `holds` is the vector-scalar form of the instruction. Dead lanes of a
// result hold nothing to rely on, unless the struct says `static constexpr int kRest = n`: then
// they keep those of operands n and up (from 0), if given. What else a struct can say is in
// checks.h.
#pragma once

#include <source_location>
#include <tuple>
#include <type_traits>

#include "simulator/machine.h"
#include "simulator/memory.h"

namespace lanescope {
namespace detail {

template <class T>
struct IsVec : std::false_type {};
template <class T, int W>
struct IsVec<Vec<T, W>> : std::true_type {};
template <class T>
inline constexpr bool kIsVec = IsVec<std::remove_cvref_t<T>>::value;

template <class T>
struct IsChecked : std::false_type {};
template <class T, int W>
struct IsChecked<CheckedVec<T, W>> : std::true_type {};
template <class T>
inline constexpr bool kIsChecked = IsChecked<std::remove_cvref_t<T>>::value;

template <class T>
struct IsMemory : std::false_type {};
template <class T>
struct IsMemory<Memory<T>> : std::true_type {};

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

/// bits() on chunks where there is one, else holds() lane by lane; a bit for each lane.
template <class Op, class Chunk>
LANESCOPE_INLINE host::ChunkBits decide_lanes(Chunk a, Chunk b) {
  if constexpr (requires { Op::bits(a, b); }) {
    return Op::bits(a, b);
  } else {
    unsigned bits = 0;
    for (int i = 0; i < host::kLanes<Chunk>; ++i)
      bits |= static_cast<unsigned>(Op::holds(a[i], b[i])) << i;
    return static_cast<host::ChunkBits>(bits);
  }
}

/// Executes an instruction on plain values.
template <class Op, int W, class... Operands>
LANESCOPE_INLINE auto execute([[maybe_unused]] Mask<W> active, const Operands&... operands) {
  if constexpr (requires { Op::apply(active, operands...); }) {
    return Op::apply(active, operands...);
  } else {
    using First = typename FirstElement<Operands...>::type;
    static_assert(!std::is_void_v<First>,
                  "the instruction does not take these operands, or none of them is a vector");
    using Chunk = typename First::Chunk;
    if constexpr (requires(host::ElementOf<Chunk> s) { Op::holds(s, s); }) {
      Mask<W> result;
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        result.chunk[c] = static_cast<host::ChunkBits>(
            active.chunk[c] & decide_lanes<Op>(chunk_of<Chunk>(operands, c)...));
      });
      return result;
    } else {
      using R = decltype(apply_lanes<Op>(chunk_of<Chunk>(operands, 0)...));
      Vec<host::ElementOf<R>, W> result;
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        result.chunk[c] = apply_lanes<Op>(chunk_of<Chunk>(operands, c)...);
      });
      return result;
    }
  }
}

template <class Operand>
LANESCOPE_INLINE const auto& plain(const Operand& operand) {
  if constexpr (kIsChecked<Operand>)
    return operand.vec;
  else
    return operand;
}

}  // namespace detail
}  // namespace lanescope

#include "simulator/checks.h"
#include "simulator/tracing.h"

namespace lanescope {

/// Makes the struct Op callable: `op(block, operands...)` issues it once in the block.
template <class Op>
struct Instruction {
  static constexpr const InstructionInfo& info() { return Op::kInfo; }

  // An overload for each number of operands: a parameter pack would leave no place for the
  // source location.
  using At = std::source_location;
  template <class On>
  LANESCOPE_INLINE auto operator()(On&& on, At at = At::current()) const {
    return issue(on, at);
  }
  template <class On, class A>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, At at = At::current()) const {
    return issue(on, at, a);
  }
  template <class On, class A, class B>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, At at = At::current()) const {
    return issue(on, at, a, b);
  }
  template <class On, class A, class B, class C>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, const C& c,
                                   At at = At::current()) const {
    return issue(on, at, a, b, c);
  }
  template <class On, class A, class B, class C, class D>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, const C& c, const D& d,
                                   At at = At::current()) const {
    return issue(on, at, a, b, c, d);
  }
  template <class On, class A, class B, class C, class D, class E>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, const C& c, const D& d,
                                   const E& e, At at = At::current()) const {
    return issue(on, at, a, b, c, d, e);
  }
  template <class On, class A, class B, class C, class D, class E, class F>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, const C& c, const D& d,
                                   const E& e, const F& f, At at = At::current()) const {
    return issue(on, at, a, b, c, d, e, f);
  }
  template <class On, class A, class B, class C, class D, class E, class F, class G>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, const C& c, const D& d,
                                   const E& e, const F& f, const G& g,
                                   At at = At::current()) const {
    return issue(on, at, a, b, c, d, e, f, g);
  }

 private:
  template <class On, class... Operands>
  LANESCOPE_INLINE static auto issue(On& on, [[maybe_unused]] const At& at,
                                     const Operands&... operands) {
    constexpr int W = std::remove_cvref_t<On>::kWidth;
    constexpr Mode M = std::remove_cvref_t<On>::kMode;
    on.template charge<Op>();
    if constexpr (M == Mode::kChecked)
      return detail::execute_checked<Op, W>(on.active(), at, operands...);
    else if constexpr (M == Mode::kTracing)
      return detail::execute_traced<Op, W>(on, at, operands...);
    else
      return detail::execute<Op, W>(on.active(), operands...);
  }
};

}  // namespace lanescope
