// SPDX-License-Identifier: MIT
// How a tracing machine executes an instruction: it tells the observer, then does it.
#pragma once

#include <source_location>

#include "simulator/issue.h"

namespace lanescope::detail {

/// The elements that one instruction touches: two words in each lane at most.
template <int W>
struct TouchList {
  Touch touches[2 * W];
  std::size_t count = 0;

  template <class T>
  void add(int lane, const Memory<T>&, std::int64_t element, bool is_store) {
    touches[count++] = {lane, static_cast<std::uint64_t>(element) * sizeof(T), sizeof(T), is_store};
  }
};

/// Not inlined: like a checked machine, a tracing one is to be built often and not to run fast.
template <class Op, int W, class On, class... Operands>
[[gnu::noinline]] auto execute_traced(const On& on, const std::source_location& at,
                                      const Operands&... operands) {
  TouchList<W> list;
  const auto add = [&](int lane, const auto& memory, std::int64_t element, bool is_store) {
    list.add(lane, memory, element, is_store);
  };
  if constexpr (requires { Op::touch(on.active(), add, operands...); })
    Op::touch(on.active(), add, operands...);
  on.tell(Op::kInfo, at, {list.touches, list.count});
  return execute<Op, W>(on.active(), operands...);
}

}  // namespace lanescope::detail
