// SPDX-License-Identifier: MIT
// Whether kernels agree with the scalar reference of their kind of work, piece by piece.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// The scalar reference of a kind of work, or null if it has none.
const Kernel* oracle_of(const Workload& workload);

/// Compares configurations that see the same work with the reference of their kind: after each of
/// some pieces the results and the counters that both have (without counting, the results alone),
/// and at the end the output, which is to be that of the kind's first vector program, at any width
/// and in any mode.
class Agreement {
 public:
  /// Opens the scene of a configuration and chooses `pieces` pieces, spread over it; 0 are all.
  /// Throws InputError as open_source() does. Requires an oracle of its kind.
  Agreement(const Configuration& configuration, int pieces, const OpeningListener& opening = {});

  /// Whether a configuration sees the pieces that were chosen.
  bool is_of(const Configuration& configuration) const {
    return same_source(configuration, chosen_for_);
  }
  std::size_t piece_count() const { return piece_count_; }

  /// Where a configuration differs first, and how, as a sentence; nothing if it agrees. What a
  /// checked machine complains of is a difference. Requires is_of().
  std::optional<std::string> difference(const Configuration& configuration);

 private:
  /// What there was after a piece.
  struct Step {
    std::uint64_t segment, ordinal;
    std::uint64_t results_hash;
    std::vector<std::uint64_t> counters;  ///< In the order of the kernel's.
  };
  /// What a kernel made of the pieces.
  struct Trail {
    std::vector<Step> steps;
    std::uint64_t output_hash = 0;
    std::string complaint;  ///< Of a checked machine; the trail ends there.
  };

  Trail trail_of(const Configuration& configuration) const;
  /// The trail of another kernel of the kind for the work and the parameters of a configuration.
  const Trail& trail_of(const Kernel& other, const Configuration& configuration);

  Configuration chosen_for_;
  std::unique_ptr<Source> source_;
  std::vector<int> segments_;
  std::size_t piece_count_ = 0;
  std::map<std::string, Trail> known_;  ///< By the JSON form of their configurations.
};

}  // namespace lanescope
