// SPDX-License-Identifier: MIT
// How an instruction is called. `inline constexpr Instruction<Op> op;` makes the struct Op callable
// on a block of any machine: op(block, operands...) issues it once there. What the block does with
// it is the machine's: charge and execute it (machine.h), or check it and tell of it as well
// (slow_machine.h). What a struct can say is in execute.h and checks.h.
#pragma once

#include <source_location>

#include "simulator/machine.h"
#include "simulator/memory.h"
#include "simulator/slow_machine.h"

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
  template <class On, class A, class B, class C, class D, class E, class F, class G, class H>
  LANESCOPE_INLINE auto operator()(On&& on, const A& a, const B& b, const C& c, const D& d,
                                   const E& e, const F& f, const G& g, const H& h,
                                   At at = At::current()) const {
    return issue(on, at, a, b, c, d, e, f, g, h);
  }

 private:
  template <class On, class... Operands>
  LANESCOPE_INLINE static auto issue(On& on, const At& at, const Operands&... operands) {
    return on.template issue<Op>(at, operands...);
  }
};

}  // namespace lanescope
