// SPDX-License-Identifier: MIT
// The page docs/instructions.md.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "simulator/instruction_example.h"
#include "simulator/instruction_list.h"

namespace lanescope {

/// An instruction as the page shows it.
struct ReferenceEntry {
  const InstructionInfo& info;
  const Suspicion* suspicion;  ///< Null if the struct has none.
  bool keeps_rest;             ///< Dead lanes of a result keep those of an operand.
  std::vector<InstructionExample> examples;
};

template <class Op>
ReferenceEntry reference_entry() {
  const Suspicion* suspicion = nullptr;
  if constexpr (detail::SaysSuspicion<Op>) suspicion = &Op::kSuspicion;
  constexpr bool kKeepsRest = requires { Op::kRest; };
  return {Op::kInfo, suspicion, kKeepsRest, examples_of<Op>()};
}

template <class... Ops>
std::vector<ReferenceEntry> reference_entries(InstructionList<Ops...>) {
  return {reference_entry<Ops>()...};
}

/// The entries of the instruction set, in the order of the list.
std::vector<ReferenceEntry> reference_entries();

/// Further items of Markdown's list of what is said of an instruction (`- ...`, each with its end
/// of line), or nothing.
using ReferenceNote = std::function<std::string(const InstructionInfo&)>;

/// A reference of instructions in Markdown: a table of all, then each one by class, with examples
/// that are executed here.
std::string instruction_reference(std::span<const ReferenceEntry> entries,
                                  const ReferenceNote& note = {});

}  // namespace lanescope
