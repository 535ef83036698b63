// SPDX-License-Identifier: MIT
// An instruction executed on a few lanes, for people to look at. The operands are chosen by what
// the struct takes; what is shown of the result comes from a machine.
#pragma once

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/issue.h"

namespace lanescope {

/// A named row of values: one for each lane, one for each element of memory, or one alone.
struct ExampleRow {
  std::string name;
  std::vector<std::string> values;
};

/// One execution of an instruction.
struct InstructionExample {
  std::string call;  ///< As a program writes it: r = add(on, a, b).
  std::vector<ExampleRow> rows;
};

namespace detail {

inline constexpr int kExampleLanes = 8;
/// Of examples on memory: few enough for the memory of all lanes to be shown.
inline constexpr int kMemoryExampleLanes = 4;

using ExampleMask = Mask<kExampleLanes>;
template <class T>
using ExampleVec = CheckedVec<T, kExampleLanes>;
using ExampleMemory = Memory<std::int32_t>;

/// An operand and what it is called.
template <class T>
struct NamedOperand {
  std::string_view name;
  T value;
};
template <class T>
NamedOperand(std::string_view, T) -> NamedOperand<T>;

/// Rows as they are filled in.
class ExampleRows {
 public:
  explicit ExampleRows(int width) : width_(width) {}

  template <class T>
  void add(std::string_view name, const ExampleVec<T>& v) {
    add_lanes(name, [&](int i) { return v.defined[i] ? to_text(v.vec[i]) : "·"; });
  }
  void add(std::string_view name, ExampleMask mask) {
    add_lanes(name, [&](int i) { return mask[i] ? "1" : "0"; });
  }
  void add(std::string_view name, const ExampleMemory& memory) {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < memory.size; ++i)
      values.push_back(fmt::format("{}", memory.data[i]));
    rows_.push_back({std::string(name), std::move(values)});
  }
  /// A scalar that is a result. One that is an operand stands in the call.
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(std::string_view name, T value) {
    rows_.push_back({std::string(name), {fmt::format("{}", value)}});
  }
  template <class T>
  void add(std::string_view, const std::pair<T, T>& pair) {
    add("r", pair.first);
    add("s", pair.second);
  }
  template <class F>
  void add_lanes(std::string_view name, F&& text) {
    std::vector<std::string> values;
    for (int i = 0; i < width_; ++i) values.emplace_back(text(i));
    rows_.push_back({std::string(name), std::move(values)});
  }

  std::vector<ExampleRow> take() { return std::move(rows_); }

 private:
  int width_;
  std::vector<ExampleRow> rows_;
};

template <class R>
constexpr std::string_view result_name() {
  if constexpr (kIsChecked<R>)
    return "r";
  else if constexpr (std::is_same_v<R, ExampleMask>)
    return "m";
  else if constexpr (std::is_arithmetic_v<R>)
    return "x";
  else
    return "(r, s)";
}

template <class T>
std::string in_call(const NamedOperand<T>& operand) {
  if constexpr (std::is_arithmetic_v<T>)
    return fmt::format("{}", operand.value);
  else
    return std::string(operand.name);
}

/// Adds the operands that are, or are not, memory.
template <bool kMemory, class... T>
void add_operands([[maybe_unused]] ExampleRows& rows, const NamedOperand<T>&... operands) {
  [[maybe_unused]] const auto one = [&]<class V>(const NamedOperand<V>& operand) {
    if constexpr (IsMemory<V>::value == kMemory && !std::is_arithmetic_v<V>)
      rows.add(operand.name, operand.value);
  };
  (one(operands), ...);
}

template <class Op, class... T>
InstructionExample execute_example(const NamedOperand<T>&... operands) {
  constexpr bool kOnMemory = (IsMemory<T>::value || ...);
  const int width = kOnMemory ? kMemoryExampleLanes : kExampleLanes;
  SlowMachine<kExampleLanes> vm(width, 1, Mode::kChecked);
  vm.leave_out(CheckSet::all());
  auto site = vm.site(0);
  auto on = site.on(ExampleMask::from_bits(0b10111011) & vm.all());

  ExampleRows rows(width);
  rows.add_lanes("lane", [](int i) { return fmt::format("{}", i); });
  rows.add("on", on.active());
  add_operands<false>(rows, operands...);
  ExampleRows memory(width);
  add_operands<true>(memory, operands...);
  std::string call = fmt::format("{}(on", Op::kInfo.mnemonic);
  ((call += fmt::format(", {}", in_call(operands))), ...);
  call += ")";

  using R = decltype(Instruction<Op>{}(on, operands.value...));
  if constexpr (std::is_void_v<R>) {
    Instruction<Op>{}(on, operands.value...);
    ((IsMemory<T>::value ? add_operands<true>(memory, NamedOperand<T>{"after", operands.value})
                         : void()),
     ...);
  } else {
    rows.add(result_name<R>(), Instruction<Op>{}(on, operands.value...));
    call = fmt::format("{} = {}", result_name<R>(), call);
  }
  InstructionExample example{std::move(call), rows.take()};
  for (ExampleRow& row : memory.take()) example.rows.push_back(std::move(row));
  return example;
}

template <class T>
ExampleVec<T> example_vec(const std::array<T, kExampleLanes>& lanes) {
  return {Vec<T, kExampleLanes>::from_lanes(lanes), ExampleMask::all()};
}

/// Operands of what single lanes compute, with values at the edges.
template <class T>
std::array<NamedOperand<ExampleVec<T>>, 3> lane_operands() {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>)
    return {{{"a", example_vec<T>({2.5f, -0.5f, 9, -0.0f, 3e9f, Limits::quiet_NaN(), 4, 7.75f})},
             {"b", example_vec<T>({2, 3, -2, 0, -1, 1, Limits::infinity(), 7.75f})},
             {"c", example_vec<T>({1, -2, 0.5f, 3, 0, 1, -1, 2})}}};
  else
    return {{{"a", example_vec<T>({5, -3, 40, Limits::min(), 6, 0, 12, 100})},
             {"b", example_vec<T>({2, 3, 9, -1, 33, 0, 4, -4})},
             {"c", example_vec<T>({1, 2, 3, 4, 5, 6, 7, 8})}}};
}

/// An example on single lanes of T, if Op computes them of one, two or three.
template <class Op, class T>
void add_lane_example(std::vector<InstructionExample>& examples) {
  const auto [a, b, c] = lane_operands<T>();
  if constexpr (requires(T x) { Op::lane(x); })
    examples.push_back(execute_example<Op>(a));
  else if constexpr (
      requires(T x) { Op::lane(x, x); } || requires(T x) { Op::holds(x, x); })
    examples.push_back(execute_example<Op>(a, b));
  else if constexpr (requires(T x) { Op::lane(x, x, x); })
    examples.push_back(execute_example<Op>(a, b, c));
}

template <class T>
using PlainOperand = std::remove_cvref_t<decltype(plain(std::declval<const T&>()))>;

/// Op acts on operands as a whole, and takes these.
template <class Op, class... T>
concept TakesWhole = requires(ExampleMask active, const PlainOperand<T>&... x) {
  Op::apply(active, x...);
}
|| requires(ExampleMask active, Width width, const PlainOperand<T>&... x) {
  Op::apply(active, width, x...);
};

/// Adds an example if there is none yet and Op takes the operands as a whole.
template <class Op, class... T>
void add_whole_example(std::vector<InstructionExample>& examples,
                       const NamedOperand<T>&... operands) {
  if constexpr (TakesWhole<Op, T...>)
    if (examples.empty()) examples.push_back(execute_example<Op>(operands...));
}

inline NamedOperand<ExampleVec<std::int32_t>> example_ints(
    std::string_view name, const std::array<std::int32_t, kExampleLanes>& lanes) {
  return {name, example_vec(lanes)};
}

template <class Op>
void add_mask_examples(std::vector<InstructionExample>& examples) {
  const NamedOperand<ExampleMask> a{"a", ExampleMask::from_bits(0b00101101)};
  const NamedOperand<ExampleMask> b{"b", ExampleMask::from_bits(0b11010101)};
  add_whole_example<Op>(examples, a);
  add_whole_example<Op>(examples, a, b);
}

template <class Op>
void add_move_examples(std::vector<InstructionExample>& examples) {
  const NamedOperand<float> s{"s", 1.5f};
  const NamedOperand<ExampleMask> chosen{"chosen", ExampleMask::from_bits(0b00101101)};
  const auto a = example_ints("a", {7, 6, 9, 14, 4, 4, 8, 6});
  const auto b = example_ints("b", {-1, -2, -3, -4, -5, -6, -7, -8});
  add_whole_example<Op>(examples);
  add_whole_example<Op>(examples, s);
  add_whole_example<Op>(examples, a, NamedOperand{"rest", b.value});
  add_whole_example<Op>(examples, chosen, a, b);
}

/// Of instructions on memory; two lanes that are on have one index.
template <class Op>
void add_memory_examples(std::vector<InstructionExample>& examples) {
  std::array<std::int32_t, 10> elements{10, 11, 12, 13, 14, 15, 16, 17, 18, 19};
  const NamedOperand<ExampleMemory> memory{"memory",
                                           {elements.data(), elements.size(), "memory", nullptr}};
  const NamedOperand<std::int64_t> offset{"offset", 1};
  const auto index = example_ints("index", {4, 1, 0, 4, 0, 0, 0, 0});
  const auto v = example_ints("v", {21, -2, 30, 5, 0, 0, 0, 0});
  const auto w = example_ints("w", {1, 2, 3, 4, 0, 0, 0, 0});
  add_whole_example<Op>(examples, memory, offset);
  add_whole_example<Op>(examples, memory, index);
  add_whole_example<Op>(examples, memory, offset, v);
  add_whole_example<Op>(examples, memory, index, v);
  add_whole_example<Op>(examples, memory, index, v, w);
}

/// Of instructions across lanes.
template <class Op>
void add_cross_lane_examples(std::vector<InstructionExample>& examples) {
  const auto a = example_ints("a", {7, 6, 9, 14, 4, 4, 8, 6});
  const auto index = example_ints("index", {3, 0, 5, 8, -1, 2, 1, 6});
  const NamedOperand<ExampleMask> selected{"selected", ExampleMask::from_bits(0b00101101)};
  const NamedOperand<int> n{"n", 2};
  add_whole_example<Op>(examples, a);
  add_whole_example<Op>(examples, selected);
  add_whole_example<Op>(examples, selected, a);
  add_whole_example<Op>(examples, a, n);
  add_whole_example<Op>(examples, a, index);
}

}  // namespace detail

/// Examples of an instruction: of what it computes lane by lane, one for float and one for int32,
/// as far as it takes them. None if it takes operands that are not foreseen here.
template <class Op>
std::vector<InstructionExample> examples_of() {
  std::vector<InstructionExample> examples;
  detail::add_lane_example<Op, float>(examples);
  detail::add_lane_example<Op, std::int32_t>(examples);
  if constexpr (Op::kInfo.instruction_class == InstructionClass::kMask)
    detail::add_mask_examples<Op>(examples);
  else if constexpr (Op::kInfo.instruction_class == InstructionClass::kMove)
    detail::add_move_examples<Op>(examples);
  else if constexpr (Op::kInfo.instruction_class == InstructionClass::kMemory)
    detail::add_memory_examples<Op>(examples);
  else
    detail::add_cross_lane_examples<Op>(examples);
  return examples;
}

}  // namespace lanescope
