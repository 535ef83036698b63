// SPDX-License-Identifier: MIT
// Instructions of a program's own: those that lanescope_program(... INSTRUCTIONS file.h) finds, and
// what is asked of their structs. What is wrong with one is an error of compilation that names it.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "simulator/instruction_set.h"

namespace lanescope {

struct ProgramInstruction {
  std::string_view struct_name;  ///< As the header has it.
  const InstructionInfo* info;
};

/// The program's own instructions, in the order of their declarations.
const std::vector<ProgramInstruction>& program_instructions();

namespace detail {

template <class Object>
struct StructOf;
template <class Op>
struct StructOf<const Instruction<Op>> {
  using type = Op;
};

/// Whether a text can be a mnemonic: small letters, digits and underscores after a letter.
constexpr bool is_mnemonic(std::string_view text) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  for (const char c : text)
    if (!is_letter(c) && !(c >= '0' && c <= '9') && c != '_') return false;
  return !text.empty() && is_letter(text.front());
}

// A name that is a member of Op as well is ambiguous in a class that inherits both. This finds
// overloads and templates, whose addresses cannot be taken.
struct NamesLane {
  int lane;
};
struct NamesHolds {
  int holds;
};
struct NamesApply {
  int apply;
};
template <class Op, class Names>
struct With : Op, Names {};

template <class Op>
concept HasLane = !requires {
  &With<Op, NamesLane>::lane;
};
template <class Op>
concept HasHolds = !requires {
  &With<Op, NamesHolds>::holds;
};
template <class Op>
concept HasApply = !requires {
  &With<Op, NamesApply>::apply;
};

/// What one lane holds.
template <class T>
concept LaneElement =
    std::same_as<T, float> || std::same_as<T, std::int32_t> || std::same_as<T, std::uint32_t>;

template <class Op>
inline constexpr int kBodies = HasLane<Op> + HasHolds<Op> + HasApply<Op>;

/// Whether a function takes values of lanes, and gives one, or a bool.
template <bool kGivesBool, class R, class... Operands>
constexpr bool is_on_lanes(R (*)(Operands...)) {
  return (LaneElement<std::remove_cvref_t<Operands>> && ...) && sizeof...(Operands) > 0 &&
         (kGivesBool ? std::same_as<R, bool> : LaneElement<R>);
}
/// Of members that are no static functions.
template <bool kGivesBool>
constexpr bool is_on_lanes(...) {
  return false;
}

/// Whether a callable takes N values of one of the types of lanes.
template <class Call, class T, std::size_t... I>
constexpr bool takes(std::index_sequence<I...>) {
  return std::invocable<Call, decltype(static_cast<void>(I), T{})...>;
}
template <class Call, std::size_t N>
inline constexpr bool kTakes = takes<Call, float>(std::make_index_sequence<N>{}) ||
                               takes<Call, std::int32_t>(std::make_index_sequence<N>{}) ||
                               takes<Call, std::uint32_t>(std::make_index_sequence<N>{});

template <class Op>
constexpr bool lane_takes_lanes() {
  if constexpr (requires { &Op::lane; }) {
    return is_on_lanes<false>(&Op::lane);
  } else {  // Overloads, or a template.
    using Call = decltype([](auto... v) -> decltype(Op::lane(v...)) { return Op::lane(v...); });
    return [&]<std::size_t... N>(std::index_sequence<N...>) { return (kTakes<Call, N + 1> || ...); }
    (std::make_index_sequence<8>{});
  }
}

template <class Op>
constexpr bool holds_takes_lanes() {
  if constexpr (requires { &Op::holds; }) {
    return is_on_lanes<true>(&Op::holds);
  } else {
    using Call = decltype([](auto... v) -> decltype(Op::holds(v...)) { return Op::holds(v...); });
    return kTakes<Call, 2>;
  }
}

}  // namespace detail

/// The struct behind the type of an object `Instruction<Struct>`.
template <class Object>
using StructOf = typename detail::StructOf<Object>::type;

/// A struct with a descriptor that lists and reports can show.
template <class Op>
concept DescribedInstruction = requires {
  requires std::same_as<decltype(Op::kInfo), const InstructionInfo>;
  requires std::bool_constant<detail::is_mnemonic(Op::kInfo.mnemonic)>::value;
  requires std::bool_constant<!Op::kInfo.meaning.empty()>::value;
};

/// A struct with one body; execute.h says what each form is.
template <class Op>
concept OneBody = detail::kBodies<Op>
== 1;

/// Unless there is a lane(): it can be executed on what lanes hold.
template <class Op>
concept LanesOfLanes = !detail::HasLane<Op> || detail::lane_takes_lanes<Op>();

/// The same of a holds().
template <class Op>
concept HoldsOfLanes = !detail::HasHolds<Op> || detail::holds_takes_lanes<Op>();

}  // namespace lanescope

/// Does not compile unless the struct of an object of Instruction can be one.
#define LANESCOPE_CHECK_INSTRUCTION(Struct, object)                                                \
  static_assert(lanescope::DescribedInstruction<lanescope::StructOf<decltype(object)>>, #Struct    \
                ": needs `static constexpr lanescope::InstructionInfo kInfo{mnemonic, meaning, "   \
                "class}`; a mnemonic is of small letters, digits and underscores");                \
  static_assert(lanescope::OneBody<lanescope::StructOf<decltype(object)>>,                         \
                #Struct ": needs one body, a static function lane(), holds() or apply()");         \
  static_assert(lanescope::LanesOfLanes<lanescope::StructOf<decltype(object)>>, #Struct            \
                ": lane() takes what lanes hold, float, std::int32_t or std::uint32_t, and gives " \
                "one of them");                                                                    \
  static_assert(lanescope::HoldsOfLanes<lanescope::StructOf<decltype(object)>>, #Struct            \
                ": holds() takes two of what lanes hold, float, std::int32_t or std::uint32_t, "   \
                "and gives a bool")
