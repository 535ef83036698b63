// SPDX-License-Identifier: MIT
// On which width two kernels cost the same on a machine, and which instruction moves that most.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/machines/run_cost.h"
#include "analysis/tables/crossing.h"

namespace lanescope {

/// Two kernels on one kind of their work.
struct KernelPair {
  Series first, second;
};

/// The names of the kernels that issue instructions, in the order of their first runs.
std::vector<std::string> vector_kernels(const Report& report);

/// The pairs of two kernels in a view, one for each facet that both were run on.
std::vector<KernelPair> pairs_of(const ReportView& view, const std::string& first,
                                 const std::string& second);

/// Slots for each element at a width, means over the scenes of the view.
struct SlotsAtWidth {
  int width = 0;
  double first = 0.0;
  double second = 0.0;

  double ratio() const { return second / first; }
};

/// Where the second kernel comes to take fewer slots than the first.
struct Crossover {
  std::vector<SlotsAtWidth> widths;  ///< Ascending; those at which both are known.
  std::optional<double> crossing;    ///< As crossing_point() has it.

  /// `12.3`, `below 8`, `above 64`; with `second falls behind at` where it is the other way round;
  /// `unknown` without widths.
  std::string words() const;
};

Crossover crossover(const ReportView& view, const KernelPair& pair, const ReportCosts& costs);

/// A crossover with the cost of one instruction halved and doubled.
struct Sensitivity {
  std::string mnemonic;
  Crossover halved, doubled;

  /// How far the crossing moves, in factors of two of W; one that lies outside of the widths
  /// measured is at the nearest of them.
  double moved() const;
  /// By how much the ratio changes at the widths measured, the most of them; as a logarithm.
  double changed() const;
  /// The factor on the cost of the instruction at which both kernels take the same at the widest of
  /// the widths; none if there is none from 0 up.
  std::optional<double> break_even() const;
};

/// For each pair, of each instruction that its runs issue: those that move the crossing most first;
/// if they move it equally, those that change the ratio most. The pairs are of the same kernels.
std::vector<std::vector<Sensitivity>> sensitivities(const ReportView& view,
                                                    const std::vector<KernelPair>& pairs,
                                                    const MachineDescription& machine,
                                                    SequenceTrials& trials);

}  // namespace lanescope
